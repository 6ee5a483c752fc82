#include "solver/ensemble/draws.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "tests/solver/ensemble/linear_model.hpp"

namespace leda::solver {
namespace {

const Place aa{"", "AA'"};

/// How often each of `slices` equal parts of (0, 1) is met.
std::vector<int> counts(const std::vector<double>& u, std::size_t slices) {
  std::vector<int> count(slices, 0);
  for (const double one : u) ++count[static_cast<std::size_t>(one * static_cast<double>(slices))];
  return count;
}

std::vector<double> coordinates(const Design& design, std::size_t dimension, std::size_t from,
                                std::size_t to, std::size_t step) {
  std::vector<double> u;
  for (std::size_t m = from; m < to; m += step) {
    u.push_back(design.coordinate(dimension, m, Key(5).with(dimension)));
  }
  return u;
}

double rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto ranks = [](const std::vector<double>& v) {
    std::vector<double> r;
    for (const double one : v) {
      r.push_back(double(std::ranges::count_if(v, [&](double other) { return other < one; })));
    }
    return r;
  };
  const auto ra = ranks(a), rb = ranks(b);
  const auto n = double(a.size());
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (ra[i] - rb[i]) * (ra[i] - rb[i]);
  return 1 - 6 * sum / (n * (n * n - 1));
}

TEST(Design, ANetStaysANetUnderItsShiftAndAfterEachDoubling) {
  const Design design({Method::sobol, 3, 4}, 3, 64, 256);
  for (std::size_t dimension = 0; dimension < 3; ++dimension) {
    for (std::size_t replicate = 0; replicate < 4; ++replicate) {
      for (const std::size_t members : {64U, 128U, 256U}) {
        const auto u = coordinates(design, dimension, replicate, members, 4);
        EXPECT_EQ(std::ranges::max(counts(u, u.size())), 1) << "the origin is left out";
      }
    }
  }
}

TEST(Design, TwoDimensionsOfANetFillEverySquare) {
  const Design design({Method::sobol, 3, 1}, 2, 64, 64);
  std::set<std::pair<int, int>> squares;
  for (std::size_t m = 0; m < 64; ++m) {
    squares.emplace(int(8 * design.coordinate(0, m, Key(1))),
                    int(8 * design.coordinate(1, m, Key(2))));
  }
  EXPECT_EQ(squares.size(), 64U);
}

TEST(Design, ALatinHypercubeHasOnePointASliceInEachOfItsParts) {
  const Design design({Method::latin, 3, 4}, 2, 64, 256);
  for (std::size_t replicate = 0; replicate < 4; ++replicate) {
    for (const auto& [from, to] : {std::pair{0U, 64U}, {64U, 128U}, {128U, 256U}}) {
      const auto u = coordinates(design, 1, from + replicate, to, 4);
      EXPECT_EQ(std::ranges::max(counts(u, u.size())), 1);
    }
  }
}

TEST(Design, ReplicatesAndDimensionsDiffer) {
  for (const Method method : {Method::sobol, Method::latin, Method::random}) {
    const Design design({method, 3, 4}, 2, 64, 64);
    EXPECT_NE(design.coordinate(0, 0, Key(1)), design.coordinate(0, 1, Key(1)));
    EXPECT_NE(design.coordinate(0, 0, Key(1)), design.coordinate(1, 0, Key(2)));
    EXPECT_NE(design.coordinate(0, 0, Key(1)), design.coordinate(0, 0, Key(2)));
  }
}

TEST(Draws, ScopesShareWhatTheyName) {
  const std::vector<UncertainInput> inputs{{"section", Scope::section, Uniform{}},
                                           {"region", Scope::region, Uniform{}},
                                           {"soil", Scope::soil, Uniform{}}};
  const auto draws = Draws::make(inputs, {}, {}, 64, 64).value();
  const auto here = draws.inputs_of({"clay", "AA'"}, 7);
  const auto same_soil = draws.inputs_of({"clay", "BB'"}, 7);
  const auto other_soil = draws.inputs_of({"silt", "CC'"}, 7);
  EXPECT_EQ(here[1], same_soil[1]);
  EXPECT_EQ(here[1], other_soil[1]);
  EXPECT_EQ(here[2], same_soil[2]);
  EXPECT_NE(here[2], other_soil[2]);
  EXPECT_NE(here[0], same_soil[0]);
  EXPECT_EQ(here, draws.inputs_of({"clay", "AA'"}, 7)) << "a draw depends on what was drawn before";
}

TEST(Draws, AnotherSeedGivesOthers) {
  const std::vector<UncertainInput> inputs{{"x", Scope::region, Uniform{}}};
  for (const Method method : {Method::sobol, Method::latin, Method::random}) {
    const auto one = Draws::make(inputs, {}, {method, 1, 8}, 64, 64).value();
    const auto two = Draws::make(inputs, {}, {method, 2, 8}, 64, 64).value();
    EXPECT_NE(one.inputs_of(aa, 3), two.inputs_of(aa, 3));
    EXPECT_NE(one.particle_seed(aa, 3), two.particle_seed(aa, 3));
  }
}

TEST(Draws, MoreMembersLeaveTheFirstAsTheyAre) {
  const std::vector<UncertainInput> inputs{{"x", Scope::section, Uniform{}},
                                           {"y", Scope::section, Uniform{}}};
  for (const Method method : {Method::sobol, Method::latin, Method::random}) {
    const auto few = Draws::make(inputs, {}, {method, 1, 8}, 64, 64).value();
    const auto many = Draws::make(inputs, {}, {method, 1, 8}, 64, 512).value();
    for (std::size_t m = 0; m < 64; ++m) EXPECT_EQ(few.inputs_of(aa, m), many.inputs_of(aa, m));
  }
}

TEST(Draws, RankCorrelationsAreAsAsked) {
  std::vector<UncertainInput> inputs{{"su", Scope::section, lognormal_of_mean(1, 0.3)},
                                     {"rate", Scope::region, Uniform{0.06, 0.12}},
                                     {"water", Scope::section, Triangular{0, 1, 4}}};
  const auto draws =
      Draws::make(inputs, {{0, 1, 0.7}, {1, 2, -0.4}}, {Method::sobol, 1, 8}, 64, 2048).value();
  std::vector<double> su, rate, water;
  for (std::size_t m = 0; m < 2048; ++m) {
    const auto x = draws.inputs_of(aa, m);
    su.push_back(x[0]);
    rate.push_back(x[1]);
    water.push_back(x[2]);
  }
  EXPECT_NEAR(rank_correlation(su, rate), 0.7, 0.02);
  EXPECT_NEAR(rank_correlation(rate, water), -0.4, 0.03);
  EXPECT_NEAR(rank_correlation(su, water), 0, 0.03);
}

TEST(Draws, WhatARegionSharesIsNotMovedByACorrelationWithASection) {
  const std::vector<UncertainInput> inputs{{"su", Scope::section, Uniform{}},
                                           {"rate", Scope::region, Uniform{}}};
  const auto draws = Draws::make(inputs, {{0, 1, 0.8}}, {}, 64, 64).value();
  EXPECT_EQ(draws.inputs_of(aa, 5)[1], draws.inputs_of({"", "BB'"}, 5)[1]);
}

TEST(Draws, CorrelationsThatContradictEachOtherAreRefused) {
  const std::vector<UncertainInput> inputs{{"a", Scope::section, Uniform{}},
                                           {"b", Scope::section, Uniform{}},
                                           {"c", Scope::section, Uniform{}}};
  EXPECT_FALSE(Draws::make(inputs, {{0, 1, 0.9}, {1, 2, 0.9}, {0, 2, -0.9}}, {}, 64, 64));
  EXPECT_TRUE(Draws::make(inputs, {{0, 1, 0.9}, {1, 2, 0.9}, {0, 2, 0.9}}, {}, 64, 64));
}

TEST(Draws, ColumnsOfOneTableComeFromTheSameRow) {
  const std::vector<double> weights{0.25, 0.25, 0.5};
  const std::vector<UncertainInput> inputs{
      {"a", Scope::region, JointSample{"posterior", {1, 2, 3}, weights}},
      {"b", Scope::region, JointSample{"posterior", {10, 20, 30}, weights}},
      {"c", Scope::region, JointSample{"other", {10, 20, 30}, weights}}};
  const auto draws = Draws::make(inputs, {}, {}, 64, 64).value();
  std::map<double, int> count;
  bool others_differ = false;
  for (std::size_t m = 0; m < 64; ++m) {
    const auto x = draws.inputs_of(aa, m);
    EXPECT_EQ(x[1], 10 * x[0]);
    others_differ = others_differ || x[2] != x[1];
    ++count[x[0]];
  }
  EXPECT_TRUE(others_differ);
  EXPECT_EQ(count[3], 32);
}

TEST(Draws, ParticlesHaveSeedsOfTheirOwn) {
  const auto draws = Draws::make({}, {}, {}, 64, 64).value();
  std::set<std::uint64_t> seeds;
  for (std::size_t m = 0; m < 64; ++m) {
    for (std::size_t repeat = 0; repeat < 4; ++repeat) {
      seeds.insert(draws.particle_seed(aa, m, repeat));
    }
  }
  EXPECT_EQ(seeds.size(), 256U);
  EXPECT_FALSE(seeds.contains(0)) << "0 is the regular lattice";
}

}  // namespace
}  // namespace leda::solver
