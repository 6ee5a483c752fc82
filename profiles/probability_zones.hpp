#pragma once
// What the ensembles of sections say on the map: zones by the probability that ground is reached.

#include <optional>
#include <string>
#include <vector>

#include "profiles/map/profile.hpp"
#include "profiles/map/zone.hpp"
#include "profiles/zonation.hpp"

namespace leda::profiles {

/// A distance that is exceeded with a probability.
struct QuantileDistance {
  std::optional<double> distance_m;  ///< absent: beyond any, so many members gave no result
  Bound is = Bound::measured;
};

/// One section and its members.
struct SectionQuantiles {
  Profile profile;
  int line = -1;
  double order = 0;    ///< m
  std::string reason;  ///< why there are no members; empty: there are
  int members = 0;
  std::vector<QuantileDistance> retrogression, runout;  ///< one an exceedance
  std::vector<std::string> warnings;
  std::string made_by;
};

/// Zones as make_zones() joins them, of the distances that are exceeded with each probability. The
/// zone of a probability holds those of all higher ones (their union is taken), so that they nest.
/// Between sections distances are interpolated, never probabilities.
/// @param exceedance ascending, within (0, 1)
/// @return from the largest zones to the smallest
/// @throws std::runtime_error where GEOS fails
std::vector<Zone> probability_zones(const std::vector<SectionQuantiles>& sections,
                                    const std::vector<double>& exceedance,
                                    const ZonationOptions& options = {});

/// Zones as far as each section goes, both ways: the ground that its members could speak of.
std::vector<Zone> zones_spoken_of(const std::vector<SectionQuantiles>& sections,
                                  const ZonationOptions& options = {});

}  // namespace leda::profiles
