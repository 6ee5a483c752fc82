#include "solver/section/gathered_warnings.hpp"

#include <gtest/gtest.h>

namespace leda {
namespace {

TEST(GatheredWarnings, TellEachTextOnceWithWhatItIsAbout) {
  GatheredWarnings gathered;
  gathered.add("S1", {"bends", "is coarse"});
  gathered.add("S2", {"is coarse", "is coarse"});
  gathered.add("S3", {"is coarse"});
  for (const char* name : {"S4", "S5", "S6"}) gathered.add(name, {"is dry"});
  gathered.add("S7", {"is dry"});
  EXPECT_EQ(lines_of(gathered), (std::vector<std::string>{"S1: bends", "S1, S2, S3: is coarse",
                                                          "S4, S5 and 2 more: is dry"}));
}

TEST(GatheredWarnings, OfNothingAreNone) {
  GatheredWarnings gathered;
  gathered.add("S1", {});
  EXPECT_TRUE(lines_of(gathered).empty());
}

}  // namespace
}  // namespace leda
