#include "server/http/auth.hpp"

#include <gtest/gtest.h>

#include <set>

#include "disk/sha256.hpp"
#include "tests/server/run_fixture.hpp"
#include "tests/server/temporary_folder.hpp"

namespace leda::server {
namespace {

class TokensTest : public testing::Test {
 protected:
  Tokens tokens(const std::string& text) {
    tests::write_text(file, text);
    std::filesystem::permissions(file, std::filesystem::perms(0600));
    return Tokens(file);
  }

  std::string refusal(const std::string& text) {
    try {
      tokens(text);
    } catch (const TokenFileError& error) {
      return error.what();
    }
    return "";
  }

  tests::TemporaryFolder folder;
  std::filesystem::path file = folder.path() / "tokens";
};

TEST_F(TokensTest, AHolderIsFoundByTheTokenAndByNothingElse) {
  const std::string anna = new_token(), ben = new_token();
  const Tokens found = tokens("# who may\n" + token_line(anna, Role::submit, "anna") + "\n\n" +
                              token_line(ben, Role::admin, "ben") + " # the second\n");
  ASSERT_TRUE(found.required());
  EXPECT_EQ(found.holder_of(anna)->name, "anna");
  EXPECT_EQ(found.holder_of(anna)->role, Role::submit);
  EXPECT_EQ(found.holder_of(ben)->role, Role::admin);
  for (const std::string& wrong :
       {std::string(), anna + " ", anna.substr(1), disk::sha256_of(anna), std::string(300, 'a')}) {
    EXPECT_FALSE(found.holder_of(wrong).has_value()) << wrong;
  }
}

TEST_F(TokensTest, EveryLineAtFaultIsTold) {
  const std::string text = refusal("read abc anna\nroot " + std::string(64, 'a') + " ben\nread " +
                                   std::string(64, 'b') + "\n");
  for (const char* line : {"line 1", "line 2", "line 3"}) {
    EXPECT_NE(text.find(line), std::string::npos) << text;
  }
  EXPECT_NE(refusal("# nobody\n").find("no token"), std::string::npos);
  EXPECT_THROW(Tokens(folder.path() / "none"), TokenFileError);
}

TEST_F(TokensTest, AFileThatOthersMayWriteIsRefused) {
  tests::write_text(file, token_line(new_token(), Role::admin, "anna") + "\n");
  std::filesystem::permissions(file, std::filesystem::perms(0622));
  EXPECT_THROW(Tokens{file}, TokenFileError);
}

TEST_F(TokensTest, NoTokenIsMadeTwice) {
  std::set<std::string> made;
  for (int i = 0; i < 100; ++i) made.insert(new_token());
  EXPECT_EQ(made.size(), 100U);
  EXPECT_EQ(made.begin()->size(), 69U);
}

TEST(BearerToken, IsReadFromTheHeaderAndNothingStrangeIs) {
  EXPECT_EQ(bearer_token("Bearer leda_12ab"), "leda_12ab");
  for (const char* header : {"", "Basic abc", "bearer x", "Bearer a b", "Bearer a\r\nX: y"}) {
    EXPECT_EQ(bearer_token(header), "") << header;
  }
}

}  // namespace
}  // namespace leda::server
