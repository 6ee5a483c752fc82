#pragma once
// A model whose answer is known: y = 40 + sum a_i x_i over independent standard normal inputs is
// normal, and a_i^2 / sum a^2 are its first-order indices.

#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "solver/ensemble/summary.hpp"

namespace leda::solver {

inline const std::vector<double> slopes{8, 5, 2};
inline constexpr double middle_m = 40;

inline double deviation_m() {
  double squares = 0;
  for (const double a : slopes) squares += a * a;
  return std::sqrt(squares);
}

inline double exact_quantile(double exceedance) {
  return boost::math::quantile(boost::math::normal(middle_m, deviation_m()), 1 - exceedance);
}

inline EnsemblePlan linear_plan(Method method, std::uint64_t seed, std::size_t members) {
  EnsemblePlan plan;
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    plan.inputs.push_back({std::to_string(i), Scope::section, Normal{}});
  }
  plan.sampling = {method, seed, method == Method::random ? 1U : 8U};
  plan.stop.min_members = 64;
  plan.stop.max_members = members;
  return plan;
}

inline Draws draws_of(const EnsemblePlan& plan) {
  return Draws::make(plan.inputs, plan.correlations, plan.sampling, plan.stop.min_members,
                     plan.stop.max_members)
      .value();
}

inline MemberOutcome at_rest(double retrogression_m, double runout_m) {
  MemberOutcome outcome;
  outcome.status = retrogression_m > 0 ? RunStatus::at_rest : RunStatus::stable;
  outcome.retrogression = Reach::measured(retrogression_m);
  outcome.runout = Reach::measured(runout_m);
  outcome.run_time_s = 1;
  return outcome;
}

inline double linear(const std::vector<double>& x) {
  double y = middle_m;
  for (std::size_t i = 0; i < x.size(); ++i) y += slopes[i] * x[i];
  return y;
}

inline std::vector<Member> linear_members(const EnsemblePlan& plan) {
  const Draws draws = draws_of(plan);
  std::vector<Member> members;
  for (std::size_t m = 0; m < plan.stop.max_members; ++m) {
    Member member;
    member.inputs = draws.inputs_of({"", "AA'"}, m);
    member.outcome = at_rest(linear(member.inputs), linear(member.inputs) / 2);
    members.push_back(std::move(member));
  }
  return members;
}

}  // namespace leda::solver
