#include "server/http/answer.hpp"

#include <gtest/gtest.h>

#include "server/operate/problem.hpp"

namespace leda::server {
namespace {

Call call_with_body(const std::string& body, bool whole = true) {
  Call call;
  call.body = [=](const std::function<bool(const char*, std::size_t)>& receive) {
    for (const char& c : body) receive(&c, 1);
    return whole;
  };
  return call;
}

TEST(Call, ReadsABodyInPieces) { EXPECT_EQ(call_with_body("{}").read_body(2), "{}"); }

TEST(Call, RefusesABodyThatIsTooLargeOrCutOff) {
  try {
    call_with_body("{ }").read_body(2);
    FAIL() << "a body of three bytes passed a limit of two";
  } catch (const Problem& problem) {
    EXPECT_EQ(problem.failure, Failure::too_large);
  }
  EXPECT_THROW(call_with_body("{", false).read_body(2), Problem);
}

TEST(Call, FindsAParameter) {
  Call call;
  call.query = {{"f", "svg"}};
  EXPECT_EQ(call.parameter("f"), "svg");
  EXPECT_FALSE(call.parameter("g"));
}

}  // namespace
}  // namespace leda::server
