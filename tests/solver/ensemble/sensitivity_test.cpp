#include "solver/ensemble/sensitivity.hpp"

#include <gtest/gtest.h>

#include "tests/solver/ensemble/linear_model.hpp"

namespace leda::solver {
namespace {

constexpr double chance_m = 4;

/// Root of the mean square error of the first input's index over ensembles of other seeds, with
/// chance on top of the inputs.
double error_of_index(Method method, std::size_t members) {
  constexpr std::uint64_t ensembles = 100;
  const double variance = deviation_m() * deviation_m() + chance_m * chance_m;
  double squares = 0;
  for (std::uint64_t seed = 1; seed <= ensembles; ++seed) {
    const auto all = linear_members(linear_plan(method, seed, members));
    std::vector<double> input;
    std::vector<std::optional<double>> y;
    for (const Member& member : all) {
      const double u = Key(seed).with(y.size()).uniform();
      input.push_back(member.inputs[0]);
      y.emplace_back(linear(member.inputs) +
                     chance_m * boost::math::quantile(boost::math::normal(), u));
    }
    const auto index = first_order_index(input, y, 8);
    squares += std::pow(index->first_order - slopes[0] * slopes[0] / variance, 2);
  }
  return std::sqrt(squares / double(ensembles));
}

TEST(Index, NearsItsExactValueWithMoreMembersByEveryDesign) {
  for (const Method method : {Method::sobol, Method::latin, Method::random}) {
    EXPECT_LT(error_of_index(method, 64), 0.11) << to_string(method);
    EXPECT_LT(error_of_index(method, 256), 0.055) << to_string(method);
  }
}

TEST(Index, OfAnInputThatDecidesAllIsNearlyOne) {
  std::vector<double> input;
  std::vector<std::optional<double>> y;
  for (int i = 0; i < 256; ++i) {
    input.push_back(i);
    y.emplace_back(-3.0 * i);
  }
  EXPECT_NEAR(first_order_index(input, y, 8)->first_order, 1, 0.01);
}

TEST(Index, MembersThatAreUnknownAreLeftOutOfIt) {
  std::vector<double> input;
  std::vector<std::optional<double>> y;
  for (int i = 0; i < 64; ++i) {
    input.push_back(i);
    y.emplace_back(i);
    if (i % 9 == 0) y.back().reset();
  }
  EXPECT_GT(first_order_index(input, y, 8)->first_order, 0.9);
}

TEST(Index, IsAbsentWhereNothingVariesOrMembersAreTooFew) {
  EXPECT_FALSE(first_order_index(std::vector<double>(64, 1), {64, std::optional(5.0)}, 8));
  EXPECT_FALSE(first_order_index({1, 2, 3}, {1.0, 2.0, 3.0}, 2));
}

}  // namespace
}  // namespace leda::solver
