#pragma once
// The inputs of every member. A draw depends on the seed, the place its scope names, the member
// and the input alone: not on order, workers or tries.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "solver/ensemble/design.hpp"
#include "solver/ensemble/distribution.hpp"
#include "solver/ensemble/rank_correlation.hpp"

namespace leda::solver {

/// What has the same draw in a member: all of the region, all sections of one soil, or one section.
enum class Scope { region, soil, section };

const char* to_string(Scope scope);  ///< "region", "soil", "section"
std::optional<Scope> scope_from(const std::string& text);

struct UncertainInput {
  std::string name;
  Scope scope = Scope::section;
  Distribution distribution;
};

struct Place {
  std::string soil;  ///< name of the soil model; empty: the only one
  std::string section;
};

/// Immutable, safe for several threads.
class Draws {
 public:
  /// @return nothing where the correlations are not positive definite
  static std::optional<Draws> make(std::vector<UncertainInput> inputs,
                                   const std::vector<RankCorrelation>& correlations,
                                   const Sampling& sampling, std::size_t first_members,
                                   std::size_t most_members);

  /// The value of each input, in their order: those at the member's coordinates.
  std::vector<double> inputs_of(const Place& place, std::size_t member) const;

  /// Where a member stands in the unit cube before inputs are correlated: one coordinate an input,
  /// the same for all columns of a table.
  std::vector<double> coordinates_of(const Place& place, std::size_t member) const;
  std::vector<double> values_at(const std::vector<double>& coordinates) const;
  /// The input whose coordinate this one has: itself, or of a table the first column.
  std::size_t coordinate_of(std::size_t input) const;

  /// Of the particles' lattice: never 0, and others for each `repeat` of the same inputs.
  std::uint64_t particle_seed(const Place& place, std::size_t member, std::size_t repeat = 0) const;

 private:
  Draws(std::vector<UncertainInput> inputs, std::vector<std::size_t> order, Copula copula,
        const Sampling& sampling, Design design);
  Key key_of(Scope scope, const Place& place) const;

  std::vector<UncertainInput> inputs_;
  std::vector<std::size_t> order_;  ///< by scope: what a region shares is not moved by a section
  Copula copula_;                   ///< over inputs in that order
  Key seed_;
  Design design_;
};

}  // namespace leda::solver
