#include "server/http/handlers/parameters.hpp"

#include <gtest/gtest.h>

#include "server/operate/problem.hpp"

namespace leda::server {
namespace {

Call call_with(const std::string& name, const std::string& value) {
  Call call;
  call.query = {{name, value}};
  call.header = [](const std::string&) { return std::string(); };
  return call;
}

TEST(Parameters, AWholeNumberIsReadWholeOrNotAtAll) {
  EXPECT_EQ(whole_number(call_with("limit", "7"), "limit", 10, 1, 100), 7);
  EXPECT_EQ(whole_number(call_with("limit", "700"), "limit", 10, 1, 100), 100);
  EXPECT_EQ(whole_number(call_with("other", "7"), "limit", 10, 1, 100), 10);
  for (const char* text : {"", "x", "1x", "-1", "0", "1.5", " 1", "99999999999999"}) {
    EXPECT_THROW(whole_number(call_with("limit", text), "limit", 10, 1, 100), Problem) << text;
  }
}

TEST(Parameters, AListIsParted) {
  EXPECT_EQ(list(call_with("sections", "AA',BB'"), "sections"),
            (std::vector<std::string>{"AA'", "BB'"}));
  EXPECT_TRUE(list(call_with("other", "x"), "sections").empty());
}

TEST(Parameters, AFormatMustBeKnown) {
  EXPECT_EQ(format(call_with("f", "svg"), {"json", "svg"}), "svg");
  EXPECT_EQ(format(call_with("g", "svg"), {"json", "svg"}), "json");
  EXPECT_THROW(format(call_with("f", "pdf"), {"json", "svg"}), Problem);
}

TEST(Parameters, TheNextLinkKeepsTheOthers) {
  Call call;
  call.query = {{"cursor", "c1"}, {"status", "failed,running"}};
  EXPECT_EQ(page_after(call, "/jobs", 0), "/jobs?status=failed%2Crunning");
  const std::string next = page_after(call, "/jobs", 1234);
  const std::string start = "/jobs?cursor=", end = "&status=failed%2Crunning";
  ASSERT_TRUE(next.starts_with(start) && next.ends_with(end)) << next;
  const auto cursor = next.substr(start.size(), next.size() - start.size() - end.size());
  EXPECT_EQ(page_start(call_with("cursor", cursor)), 1234);
}

TEST(Parameters, ACursorIsOneOfANextLink) {
  EXPECT_EQ(page_start(Call{}), 0);
  for (const char* text : {"", "c", "12", "c-1", "cxyz", "c1 ", "cffffffffffffffffff"}) {
    EXPECT_THROW(page_start(call_with("cursor", text)), Problem) << text;
  }
}

}  // namespace
}  // namespace leda::server
