#include "server/http/gate.hpp"

#include <gtest/gtest.h>

#include <map>

#include "server/http/problem_answer.hpp"
#include "tests/server/run_fixture.hpp"
#include "tests/server/temporary_folder.hpp"

namespace leda::server {
namespace {

HeaderOf headers(const std::map<std::string, std::string>& given) {
  return [given](const std::string& name) {
    const auto found = given.find(name);
    return found == given.end() ? "" : found->second;
  };
}

/// The status of the refusal; 0 where the request is let in.
template <class Call>
int refused(Call call) {
  try {
    call();
  } catch (const Problem& problem) {
    return status_of(problem.failure);
  }
  return 0;
}

class GateTest : public testing::Test {
 protected:
  GateTest() {
    const auto file = folder.path() / "tokens";
    tests::write_text(file, token_line(reader, Role::read, "r") + "\n" +
                                token_line(submitter, Role::submit, "s") + "\n" +
                                token_line(admin, Role::admin, "a") + "\n");
    tokens = Tokens(file);
  }

  int at_the_gate(const std::map<std::string, std::string>& given, bool with_tokens = false) {
    return refused([&] {
      refuse_at_the_gate(headers(given), with_tokens ? tokens : Tokens(),
                         "https://leda.example.org");
    });
  }

  int with(const std::string& token, Role role) {
    return refused([&] {
      require_role(role, headers({{"Authorization", "Bearer " + token}}), tokens);
    });
  }

  tests::TemporaryFolder folder;
  std::string reader = new_token(), submitter = new_token(), admin = new_token();
  Tokens tokens;
};

TEST_F(GateTest, FormsStayOutside) {
  EXPECT_EQ(at_the_gate({{"Content-Type", "multipart/form-data; boundary=x"}}), 415);
  EXPECT_EQ(at_the_gate({{"Content-Type", "image/tiff"}}), 0);
}

TEST_F(GateTest, PagesOfOtherSitesStayOutside) {
  EXPECT_EQ(at_the_gate({{"Host", "127.0.0.1:8080"}}), 0);
  EXPECT_EQ(at_the_gate({{"Host", "leda.example.org"}, {"Origin", "https://leda.example.org"}}), 0);
  EXPECT_EQ(at_the_gate({{"Host", "rebound.example.org"}}), 403);
  EXPECT_EQ(at_the_gate({{"Host", "127.0.0.1.example.org"}}), 403);
  EXPECT_EQ(at_the_gate({{"Host", "localhost"}, {"Origin", "https://example.org"}}), 403);
  EXPECT_EQ(at_the_gate({{"Host", "localhost"}, {"Origin", "null"}}), 403);
  EXPECT_EQ(at_the_gate({{"Host", "10.0.0.7:8080"}}, true), 0);
  EXPECT_EQ(at_the_gate({{"Host", "10.0.0.7:8080"}, {"Origin", "http://10.0.0.7:8080"}}, true), 0);
  EXPECT_EQ(at_the_gate({{"Host", "10.0.0.7:8080"}, {"Origin", "https://example.org"}}, true), 403);
}

TEST_F(GateTest, ARoleOpensWhatItMayAndNoMore) {
  EXPECT_EQ(with(reader, Role::read), 0);
  EXPECT_EQ(with(reader, Role::submit), 403);
  EXPECT_EQ(with(submitter, Role::submit), 0);
  EXPECT_EQ(with(submitter, Role::admin), 403);
  EXPECT_EQ(with(admin, Role::admin), 0);
  EXPECT_EQ(with("", Role::read), 401);
  EXPECT_EQ(with(new_token(), Role::read), 401);
  EXPECT_EQ(with(new_token(), Role::anyone), 0);
}

TEST_F(GateTest, WithoutTokensEverybodyOfThisMachineMayDoEverything) {
  EXPECT_EQ(require_role(Role::admin, headers({}), Tokens()).role, Role::admin);
}

TEST(LocalName, IsThisMachineAlone) {
  for (const char* name : {"127.0.0.1", "localhost:80", "[::1]", "[::1]:8080"}) {
    EXPECT_TRUE(is_local_name(name)) << name;
  }
  for (const char* name : {"", "localhost.example.org", "[::1].example.org", "127.0.0.2", "[::]"}) {
    EXPECT_FALSE(is_local_name(name)) << name;
  }
}

}  // namespace
}  // namespace leda::server
