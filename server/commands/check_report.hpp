#pragma once
// What `leda check` says of the extreme cases: a table, JSON, CSV.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "solver/extremes/extreme_case.hpp"

namespace leda::server {

/// "at-rest", "refused", "unstable"; of a bisection "gamma H / s_u = 4.02".
std::string outcome_in_a_word(const solver::Outcome& outcome);

std::string check_header();
/// One line of the table, with what broke a promise on lines of its own beneath.
std::string check_line(const solver::Outcome& outcome);

/// {"kept": all promises were, "cases": [...]}; errors as fractions, distances in m, times in s.
nlohmann::json check_document(const std::vector<solver::Outcome>& outcomes);

std::string check_csv(const std::vector<solver::Outcome>& outcomes);

}  // namespace leda::server
