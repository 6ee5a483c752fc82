#pragma once
// The random fields of a section's materials at its particles, while they are seeded.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "solver/materials/strength_field.hpp"
#include "solver/section/section.hpp"

namespace leda::solver {

/// What the particles of a material got.
struct SampledField {
  std::string material;
  double cov = 0;  ///< of the field
  std::int64_t particles = 0;
  double sum = 0, least = 0, most = 0;  ///< of the factors

  /// For the result's warnings: how strength came out.
  std::string told() const;
};

/// Goes through the ground a vertical of particles at a time.
class SampledFields {
 public:
  /// @param z elevations of particles, upwards, m; keep the section alive
  SampledFields(const Section& section, std::uint64_t seed, const std::vector<double>& z);

  /// To the vertical through x, of which `count` elevations lie in the ground.
  void move_to(double x, std::size_t count);

  /// Factor on the strength of a material at one of these elevations; 1 without a field.
  double take(std::size_t material_index, std::size_t elevation);

  /// Of the materials that particles were taken of.
  std::vector<SampledField> sampled() const;

 private:
  struct Sampling {
    StrengthField field;
    SampledField sampled;
    std::vector<double> factors;  ///< on the vertical
  };

  std::vector<std::optional<Sampling>> of_material_;
};

}  // namespace leda::solver
