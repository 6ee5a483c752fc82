#include "profiles/soil_along.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "profiles/map_geometry.hpp"

namespace leda::profiles {
namespace {

constexpr int samples = 400;
constexpr double least_share = 0.01;  // of the section; less is the drawing's inaccuracy

bool holds(const SoilModel& model, MapPoint p) {
  return std::ranges::any_of(model.where,
                             [&](const MapPolygon& area) { return is_inside(area, p); });
}

/// How often of `samples`, by models: one on its own, or the first two that overlap.
struct Along {
  std::map<std::size_t, int> taken;
  std::map<std::pair<std::size_t, std::size_t>, int> overlapping;
  int without = 0;
};

Along walk(const Profile& profile, const std::vector<SoilModel>& soil) {
  Along along;
  const double length = length_of(profile.trace);
  for (int i = 0; i < samples; ++i) {
    const MapPoint p = point_at(profile.trace, length * (i + 0.5) / samples);
    const auto taken = model_at(p, soil);
    if (!taken) {
      ++along.without;
      continue;
    }
    ++along.taken[*taken];
    for (std::size_t other = *taken + 1; other < soil.size(); ++other) {
      if (soil[*taken].where.empty() || !holds(soil[other], p)) continue;
      ++along.overlapping[{*taken, other}];
      break;
    }
  }
  return along;
}

double percent(int count) { return 100.0 * count / samples; }
bool counts(int count) { return count >= least_share * samples; }

}  // namespace

std::optional<std::size_t> model_at(MapPoint p, const std::vector<SoilModel>& soil) {
  std::optional<std::size_t> everywhere;
  for (std::size_t i = 0; i < soil.size(); ++i) {
    if (soil[i].where.empty() && !everywhere) everywhere = i;
    if (holds(soil[i], p)) return i;
  }
  return everywhere;
}

std::vector<std::string> warnings_of_soils(const Profile& profile,
                                           const std::vector<SoilModel>& soil, std::size_t taken) {
  if (soil.size() < 2 && soil[taken].where.empty()) return {};
  const Along along = walk(profile, soil);
  std::vector<std::string> warnings;
  std::string others;
  for (const auto& [model, count] : along.taken) {
    if (model == taken || !counts(count)) continue;
    others += fmt::format("{}{:.0f} % of it on soil '{}'", others.empty() ? "" : ", ",
                          percent(count), soil[model].name);
  }
  if (counts(along.without)) {
    others += fmt::format("{}{:.0f} % of it on no soil", others.empty() ? "" : ", ",
                          percent(along.without));
  }
  if (!others.empty()) {
    warnings.push_back(fmt::format(
        "soil '{}', that of the crest, is taken for the whole section, which lies with {}",
        soil[taken].name, others));
  }
  for (const auto& [models, count] : along.overlapping) {
    if (!counts(count)) continue;
    warnings.push_back(fmt::format(
        "the polygons of soils '{}' and '{}' overlap on {:.0f} % of the section: there '{}', which "
        "stands first, is taken",
        soil[models.first].name, soil[models.second].name, percent(count),
        soil[models.first].name));
  }
  return warnings;
}

}  // namespace leda::profiles
