#pragma once
// Weights of members, and whether they carry what is said with them.

#include <cstddef>
#include <optional>
#include <vector>

namespace leda::solver {

/// ln of the sum of exponentials; minus infinity where all are.
double log_sum(const std::vector<double>& logs);

/// Weights that add up to 1. All 0 where every logarithm is minus infinity.
std::vector<double> normalized(const std::vector<double>& logs);

/// 1 / sum of squares of the weights: so many equal members would say as much (Kish 1965).
/// @param weights add up to 1, or are all 0: then nothing is effective
double effective_members(const std::vector<double>& weights);

/// Shape k of the generalized Pareto distribution of the largest weights (Vehtari, Simpson, Gelman,
/// Yao and Gabry 2024, J. Mach. Learn. Res. 25, 72; fit by Zhang and Stephens 2009 with the weak
/// prior of R package loo). Above 0.7 means by these weights are not to be trusted.
/// @return nothing where fewer than 5 weights are largest ones, or these do not differ
std::optional<double> pareto_k(const std::vector<double>& logs);

/// Up to here a shape is good with so many members: min(1 - 1 / log10(members), 0.7).
double largest_good_k(std::size_t members);

/// ln of prior x likelihood^exponent, one a member. A member that is ruled out stays so at any
/// exponent.
std::vector<double> tempered(const std::vector<double>& log_prior,
                             const std::vector<double>& log_likelihood, double exponent);

/// The largest exponent t from 0 to 1 with which weights prior x likelihood^t have the wanted
/// effective members; 0 where not even the prior has them.
/// @param log_prior and @param log_likelihood one a member
double tempering_exponent(const std::vector<double>& log_prior,
                          const std::vector<double>& log_likelihood, double effective);

}  // namespace leda::solver
