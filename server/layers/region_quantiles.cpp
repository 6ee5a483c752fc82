#include "server/layers/region_quantiles.hpp"

#include <fmt/format.h>

#include "disk/sha256.hpp"
#include "server/layers/job_ensemble.hpp"

namespace leda::server {
namespace {

using db::SectionRecord;
using solver::Distance;

std::vector<profiles::QuantileDistance> distances_at(const solver::ExceedanceCurve& curve,
                                                     const std::vector<double>& exceedance) {
  std::vector<profiles::QuantileDistance> distances;
  for (const double p : exceedance) {
    const auto distance = solver::distance_exceeded(curve, p);
    const bool bound = distance && solver::is_lower_bound(curve, *distance);
    distances.push_back({distance, bound ? Bound::lower_bound : Bound::measured});
  }
  return distances;
}

/// What a reader of the zone should know of the members.
std::vector<std::string> warnings_of(const solver::EnsembleSummary& summary) {
  std::size_t unknown = 0;
  for (const char* status : {"no-result", "unstable"}) {
    const auto found = summary.by_status.find(status);
    if (found != summary.by_status.end()) unknown += found->second;
  }
  std::vector<std::string> warnings;
  if (unknown > 0) {
    warnings.push_back(
        fmt::format("{} of {} members gave no usable result: each counts half as at "
                    "rest and half as beyond any distance",
                    unknown, summary.members));
  }
  if (summary.ending == solver::Ending::max_members) {
    warnings.push_back(fmt::format("the most members allowed, {}, know its probabilities to {:.2f}",
                                   summary.members, summary.half_width));
  }
  return warnings;
}

/// Over what made the curves.
std::string hash_of(const SectionRecord& section, const solver::EnsembleSummary& summary) {
  std::string text = section.name + fmt::format("\n{}", summary.members);
  for (const auto& [distance, of] : summary.by_distance) {
    for (const auto& point : of.curve.points) {
      text += fmt::format("\n{:.17g} {:.17g}", point.distance_m, point.probability);
    }
  }
  return disk::sha256_of(text);
}

}  // namespace

std::vector<profiles::SectionQuantiles> region_quantiles(const db::Store& store,
                                                         const Ensemble& ensemble,
                                                         const std::vector<SoilModel>& soil,
                                                         const std::vector<SectionRecord>& sections,
                                                         const std::vector<double>& exceedance) {
  std::vector<profiles::SectionQuantiles> all;
  for (const SectionRecord& section : sections) {
    profiles::SectionQuantiles one;
    one.profile = profile_of(section);
    one.line = section.line;
    one.order = section.order;
    const auto look =
        last_look(ensemble, place_of(section, soil), store.members(section.job, section.ordinal));
    if (look) {
      const auto& by = look->summary.by_distance;
      one.members = static_cast<int>(look->members);
      one.retrogression = distances_at(by.at(Distance::retrogression).curve, exceedance);
      one.runout = distances_at(by.at(Distance::runout).curve, exceedance);
      one.warnings = warnings_of(look->summary);
      one.made_by = hash_of(section, look->summary);
    } else {
      one.reason = section.reason.empty() ? "it has no members" : section.reason;
    }
    all.push_back(std::move(one));
  }
  return all;
}

}  // namespace leda::server
