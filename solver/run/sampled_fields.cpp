#include "solver/run/sampled_fields.hpp"

#include <algorithm>
#include <cmath>

#include "solver/section/fault_list.hpp"

namespace leda::solver {
namespace {

std::string rounded(double value) { return show(std::round(value * 1000) / 1000); }

}  // namespace

std::string SampledField::told() const {
  const double mean = sum / static_cast<double>(particles);
  return "strength of " + material + " varies within the ground (cov " + show(cov) +
         "): " + rounded(least) + " to " + rounded(most) + " times peak_strength_kPa, " +
         rounded(mean) + " on average of " + std::to_string(particles) + " particles";
}

SampledFields::SampledFields(const Section& section, std::uint64_t seed,
                             const std::vector<double>& z) {
  for (const auto& [name, m] : section.materials) {
    auto& sampling = of_material_.emplace_back();
    if (!m.field) continue;
    sampling = Sampling{StrengthField(*m.field, seed, name, z), {}, {}};
    sampling->sampled.material = name;
    sampling->sampled.cov = m.field->cov;
  }
}

void SampledFields::move_to(double x, std::size_t count) {
  for (auto& sampling : of_material_) {
    if (sampling) sampling->factors = sampling->field.factors(x, count);
  }
}

double SampledFields::take(std::size_t material_index, std::size_t elevation) {
  auto& sampling = of_material_[material_index];
  if (!sampling) return 1;
  const double factor = sampling->factors[elevation];
  SampledField& sampled = sampling->sampled;
  sampled.least = sampled.particles == 0 ? factor : std::min(sampled.least, factor);
  sampled.most = std::max(sampled.most, factor);
  sampled.sum += factor;
  ++sampled.particles;
  return factor;
}

std::vector<SampledField> SampledFields::sampled() const {
  std::vector<SampledField> all;
  for (const auto& sampling : of_material_) {
    if (sampling && sampling->sampled.particles > 0) all.push_back(sampling->sampled);
  }
  return all;
}

}  // namespace leda::solver
