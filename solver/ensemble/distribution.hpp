#pragma once
// What is known of an uncertain number, and its quantiles, by Boost.Math. Parameters carry the
// unit of the number they stand for; a lognormal one is always given by named parameters, since
// its two readings are the usual mistake.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "solver/section/fault_list.hpp"

namespace leda::solver {

/// Truncated where min or max is given: what lies beyond is not drawn.
struct Normal {
  double mean = 0, sd = 1;
  std::optional<double> min, max;
};

struct Lognormal {
  double median = 1;
  double sd_ln = 0.1;  ///< of the natural logarithm
};

struct Uniform {
  double min = 0, max = 1;
};

struct Triangular {
  double min = 0, mode = 0.5, max = 1;
};

/// A beta distribution over min to max whose mean is (min + 4 mode + max) / 6.
struct Pert {
  double min = 0, mode = 0.5, max = 1;
};

struct Discrete {
  std::vector<double> values, weights;  ///< weights add up to 1
};

/// One column of a table of members with weights. Inputs whose `set` is the same are columns of
/// one table: a member takes all of them from the same row.
struct JointSample {
  std::string set;
  std::vector<double> values, weights;  ///< weights add up to 1
};

using Distribution =
    std::variant<Normal, Lognormal, Uniform, Triangular, Pert, Discrete, JointSample>;

/// sd_ln^2 = ln(1 + cov^2), median = mean / sqrt(1 + cov^2).
/// @param mean arithmetic, above 0
/// @param cov standard deviation over mean, above 0
Lognormal lognormal_of_mean(double mean, double cov);

/// Whether every value between two others may be drawn.
bool is_continuous(const Distribution& distribution);

/// The value that is not exceeded with probability u.
/// @pre check() found no fault; 0 < u < 1
double quantile(const Distribution& distribution, double u);

/// Faults of the parameters, each at `at` and the parameter's name.
void check(const Distribution& distribution, const std::string& at, FaultList& faults);

}  // namespace leda::solver
