#include "server/documents/object_reader.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/server/documents/read_data.hpp"

namespace leda::server {
namespace {

using nlohmann::json;
using Pointers = std::multiset<std::string>;

TEST(ObjectReader, ReadsWhatIsThere) {
  const json value = json::parse(R"({"n": 2.5, "i": 7, "b": true, "t": "text", "p": [1, 2]})");
  FaultList faults;
  ObjectReader reader(value, "/at", faults);
  EXPECT_EQ(reader.number("n"), 2.5);
  EXPECT_EQ(reader.integer_or("i", 1), 7);
  EXPECT_TRUE(reader.boolean_or("b", false));
  EXPECT_EQ(reader.text("t"), "text");
  EXPECT_EQ(reader.optional_point("p"), (Point{1, 2}));
  EXPECT_EQ(reader.number_or("absent", 4), 4);
  EXPECT_FALSE(reader.optional_number("absent"));
  reader.refuse_unknown();
  EXPECT_TRUE(faults.take().empty());
}

TEST(ObjectReader, NamesMissingWrongAndUnknownMembers) {
  const json value = json::parse(
      R"({"n": "1", "i": 1.5, "b": 0, "t": "line\nfeed", "p": [1], "h": 1e13, "x~/": 1, "z": null})");
  FaultList faults;
  ObjectReader reader(value, "/at", faults);
  EXPECT_TRUE(std::isnan(reader.number("n")));
  EXPECT_TRUE(std::isnan(reader.number("absent")));
  EXPECT_TRUE(std::isnan(reader.number("h")));
  EXPECT_TRUE(std::isnan(reader.number_or("z", 3)));
  EXPECT_EQ(reader.integer_or("i", 9), 9);
  EXPECT_FALSE(reader.boolean_or("b", false));
  EXPECT_EQ(reader.text("t"), "");
  reader.optional_point("p");
  reader.refuse_unknown();
  EXPECT_EQ(test::pointers(faults.take()),
            (Pointers{"/at/n", "/at/absent", "/at/h", "/at/z", "/at/i", "/at/b", "/at/t", "/at/p",
                      "/at/x~0~1"}));
}

TEST(ObjectReader, WhatIsNoObjectIsOneFault) {
  const json value = json::array();
  FaultList faults;
  ObjectReader reader(value, "/at", faults);
  reader.number("n");
  reader.text("t");
  reader.refuse_unknown();
  EXPECT_EQ(test::pointers(faults.take()), Pointers{"/at"});
}

TEST(AddNewFaults, LeavesOutWhatIsAtFaultAlready) {
  std::vector<Fault> faults{{"/a/b", ""}, {"/c", ""}};
  add_new_faults(faults,
                 {{"/a", ""}, {"/a/b", ""}, {"/a/bc", ""}, {"/c/d", ""}, {"/e", ""}, {"/e", ""}});
  EXPECT_EQ(test::pointers(faults), (Pointers{"/a/b", "/a/bc", "/c", "/e", "/e"}));
}

}  // namespace
}  // namespace leda::server
