#include "profiles/place_result.hpp"

#include <cmath>

#include "profiles/map_geometry.hpp"
#include "solver/section/warnings.hpp"

namespace leda::profiles {
namespace {

PlacedResult at_rest_on(const Profile& profile, int line, double order,
                        const std::string& made_by) {
  PlacedResult placed;
  placed.section = profile.section;
  placed.line = line;
  placed.order = order;
  placed.known = true;
  placed.crest = point_on_trace(profile, profile.bank.crest.x);
  placed.toe = point_on_trace(profile, profile.bank.toe.x);
  placed.backscarp = placed.toe;
  placed.front = placed.toe;
  placed.warnings = profile.warnings;
  placed.made_by = made_by;
  return placed;
}

}  // namespace

MapPoint point_on_trace(const Profile& profile, double x_m) {
  // The ground spans the whole trace, which gives the CRS unit without asking the DEM.
  const double start = profile.ground.front().x;
  const double share = (x_m - start) / (profile.ground.back().x - start);
  return point_at(profile.trace, share * length_of(profile.trace));
}

PlacedResult place_result(const Profile& profile, int line, double order,
                          const SectionResult& result, const std::string& made_by) {
  PlacedResult placed = at_rest_on(profile, line, order, made_by);
  placed.warnings = result.warnings;
  add_new(placed.warnings, profile.warnings);
  if (result.status == RunStatus::unstable || result.status == RunStatus::interrupted) {
    placed.known = false;
    placed.warnings.push_back(std::string("the run is ") + to_string(result.status) +
                              (result.reason.empty() ? "" : ": " + result.reason));
    return placed;
  }
  placed.retrogression_m = result.crest_to_crest_retrogression_m;
  placed.runout_m = result.runout_m;
  placed.retrogression_is = result.retrogression_is;
  placed.runout_is = result.runout_is;
  placed.moved =
      result.status != RunStatus::stable && (placed.retrogression_m > 0 || placed.runout_m > 0);
  if (!placed.moved) return placed;
  placed.backscarp = point_on_trace(profile, result.backscarp.x);
  placed.front = point_on_trace(profile, result.front.x);
  if (result.front.x < profile.ground.front().x || result.front.x > profile.ground.back().x) {
    placed.warnings.emplace_back("the debris runs beyond the end of the section");
  }
  return placed;
}

PlacedResult place_stable(const Profile& profile, int line, double order,
                          const std::string& made_by) {
  return at_rest_on(profile, line, order, made_by);
}

PlacedResult place_unknown(const std::string& section, const MapLine& trace, int line, double order,
                           const std::string& reason) {
  PlacedResult placed;
  placed.section = section;
  placed.line = line;
  placed.order = order;
  const MapPoint middle = point_at(trace, length_of(trace) / 2);
  placed.backscarp = placed.crest = placed.toe = placed.front = middle;
  placed.warnings = {reason};
  return placed;
}

}  // namespace leda::profiles
