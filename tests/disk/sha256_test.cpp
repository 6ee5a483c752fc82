#include "disk/sha256.hpp"

#include <gtest/gtest.h>

namespace leda::disk {
namespace {

// FIPS 180-4 examples.
TEST(Sha256, KnownTexts) {
  EXPECT_EQ(sha256_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Sha256, IsKnownWhenSeen) {
  EXPECT_TRUE(is_sha256(sha256_of("abc")));
  EXPECT_FALSE(is_sha256(""));
  EXPECT_FALSE(is_sha256(std::string(64, 'A')));
  EXPECT_FALSE(is_sha256(std::string(63, 'a')));
}

}  // namespace
}  // namespace leda::disk
