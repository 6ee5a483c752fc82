#include "server/documents/softening_names.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>
#include <variant>

#include "server/documents/soil_reader.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

SofteningLaw read_urmi(ObjectReader& reader) {
  UrmiSoftening law;
  law.alpha = reader.number("alpha");
  law.beta = reader.number("beta");
  law.residual_strain = reader.number("residual_strain");
  law.remolded_strength_Pa = reader.number("remolded_strength_kPa") * kilo;
  if (const auto residual = reader.optional_number("residual_strength_kPa")) {
    law.residual_strength_Pa = *residual * kilo;
  }
  law.remolded_strain = reader.optional_number("remolded_strain");
  return law;
}

SofteningLaw read_einav_randolph(ObjectReader& reader) {
  EinavRandolphSoftening law;
  law.remolded_strength_Pa = reader.number("remolded_strength_kPa") * kilo;
  law.strain_95 = reader.number("strain_95");
  return law;
}

SofteningLaw read_exponential(ObjectReader& reader) {
  ExponentialSoftening law;
  law.remolded_strength_Pa = reader.number("remolded_strength_kPa") * kilo;
  law.shape_factor = reader.number("shape_factor");
  return law;
}

SofteningLaw read_linear(ObjectReader& reader) {
  LinearSoftening law;
  law.remolded_strength_Pa = reader.number("remolded_strength_kPa") * kilo;
  law.remolded_strain = reader.number("remolded_strain");
  return law;
}

SofteningLaw read_dey(ObjectReader& reader) {
  DeySoftening law;
  law.remolded_strength_Pa = reader.number("remolded_strength_kPa") * kilo;
  law.strain_95 = reader.number("strain_95");
  law.large_strain = reader.number("large_strain");
  law.large_strain_strength_Pa = reader.number("large_strain_strength_kPa") * kilo;
  return law;
}

constexpr std::array<SofteningName, 5> laws{{
    {"urmi", read_urmi},
    {"einav-randolph", read_einav_randolph},
    {"exponential", read_exponential},
    {"linear", read_linear},
    {"dey", read_dey},
}};

constexpr std::array<std::pair<Regularization, const char*>, 4> regularizations{{
    {Regularization::beta, "beta"},
    {Regularization::whole_curve, "whole-curve"},
    {Regularization::band, "band"},
    {Regularization::none, "none"},
}};

struct WriteLaw {
  json operator()(const UrmiSoftening& law) const {
    json out{{"law", "urmi"},
             {"alpha", law.alpha},
             {"beta", law.beta},
             {"residual_strain", law.residual_strain},
             {"remolded_strength_kPa", per_kilo(law.remolded_strength_Pa)}};
    if (law.residual_strength_Pa) {
      out["residual_strength_kPa"] = per_kilo(*law.residual_strength_Pa);
    }
    if (law.remolded_strain) out["remolded_strain"] = *law.remolded_strain;
    return out;
  }
  json operator()(const EinavRandolphSoftening& law) const {
    return {{"law", "einav-randolph"},
            {"remolded_strength_kPa", per_kilo(law.remolded_strength_Pa)},
            {"strain_95", law.strain_95}};
  }
  json operator()(const ExponentialSoftening& law) const {
    return {{"law", "exponential"},
            {"remolded_strength_kPa", per_kilo(law.remolded_strength_Pa)},
            {"shape_factor", law.shape_factor}};
  }
  json operator()(const LinearSoftening& law) const {
    return {{"law", "linear"},
            {"remolded_strength_kPa", per_kilo(law.remolded_strength_Pa)},
            {"remolded_strain", law.remolded_strain}};
  }
  json operator()(const DeySoftening& law) const {
    return {{"law", "dey"},
            {"remolded_strength_kPa", per_kilo(law.remolded_strength_Pa)},
            {"strain_95", law.strain_95},
            {"large_strain", law.large_strain},
            {"large_strain_strength_kPa", per_kilo(law.large_strain_strength_Pa)}};
  }
};

}  // namespace

const SofteningName* softening_named(std::string_view name) {
  for (const SofteningName& law : laws) {
    if (name == law.name) return &law;
  }
  return nullptr;
}

std::string softening_names() {
  std::string names;
  for (const SofteningName& law : laws)
    names += (names.empty() ? "" : ", ") + std::string(law.name);
  return names;
}

std::optional<Regularization> regularization_named(std::string_view name) {
  for (const auto& [value, known] : regularizations) {
    if (name == known) return value;
  }
  return std::nullopt;
}

json to_document(const Softening& softening) {
  json out = std::visit(WriteLaw{}, softening.law);
  out["reference_size_m"] = softening.reference_size_m;
  for (const auto& [value, name] : regularizations) {
    if (value == softening.regularization) out["regularization"] = name;
  }
  if (softening.regularization == Regularization::band) out["band_m"] = softening.band_m;
  return out;
}

double per_kilo(double si) {
  const double quotient = si / kilo;
  const std::array candidates{quotient, std::nextafter(quotient, -INFINITY),
                              std::nextafter(quotient, INFINITY)};
  double best = quotient;
  std::size_t digits = std::string::npos;
  for (const double candidate : candidates) {
    if (candidate * kilo != si) continue;
    const std::size_t length = fmt::format("{}", candidate).size();
    if (length >= digits) continue;
    best = candidate;
    digits = length;
  }
  return best;
}

}  // namespace leda::server
