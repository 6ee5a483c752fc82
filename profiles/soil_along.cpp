#include "profiles/soil_along.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "profiles/map_geometry.hpp"
#include "profiles/place_result.hpp"

namespace leda::profiles {
namespace {

constexpr int samples = 400;
constexpr double border_tolerance_m = 0.01;
constexpr double least_share = 0.01;  // of the section; less is the drawing's inaccuracy

bool holds(const SoilModel& model, MapPoint p) {
  return std::ranges::any_of(model.where,
                             [&](const MapPolygon& area) { return is_inside(area, p); });
}

/// How often of `samples`: on no soil, or on two models that overlap.
struct Along {
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

/// Where the soil of the left ends, to a centimetre.
template <class ModelOf>
double border_between(const ModelOf& model_of, double left, double right, std::size_t model) {
  while (right - left > border_tolerance_m) {
    const double middle = 0.5 * (left + right);
    (model_of(middle) == model ? left : right) = middle;
  }
  return right;
}

/// Gives each piece that is too short to the one before it, the first to the one after it, and
/// joins neighbours on the same soil.
std::vector<SoilPart> without_slivers(std::vector<SoilPart> parts, double least_m) {
  std::vector<SoilPart> kept;
  for (const SoilPart& part : parts) {
    const bool sliver = part.to_m - part.from_m < least_m;
    if (kept.empty() || (!sliver && kept.back().model != part.model)) {
      kept.push_back(part);
    } else {
      kept.back().to_m = part.to_m;
    }
    const bool first_was_sliver = kept.size() == 2 && kept[0].to_m - kept[0].from_m < least_m;
    if (!first_was_sliver) continue;
    kept[1].from_m = kept[0].from_m;
    kept.erase(kept.begin());
  }
  return kept;
}

}  // namespace

std::optional<std::size_t> model_at(MapPoint p, const std::vector<SoilModel>& soil) {
  std::optional<std::size_t> everywhere;
  for (std::size_t i = 0; i < soil.size(); ++i) {
    if (soil[i].where.empty() && !everywhere) everywhere = i;
    if (holds(soil[i], p)) return i;
  }
  return everywhere;
}

std::vector<SoilPart> soil_parts(const Profile& profile, const std::vector<SoilModel>& soil) {
  const double start = profile.ground.front().x;
  const double length = profile.ground.back().x - start;
  const auto model_of = [&](double x) { return model_at(point_on_trace(profile, x), soil); };
  std::vector<SoilPart> parts;
  for (int i = 0; i < samples; ++i) {
    const double middle = start + length * (i + 0.5) / samples;
    const auto model = model_of(middle);
    if (!model) continue;
    if (parts.empty()) {
      parts.push_back({start, middle, *model});
    } else if (parts.back().model == *model) {
      parts.back().to_m = middle;
    } else {
      const double border = border_between(model_of, parts.back().to_m, middle, parts.back().model);
      parts.back().to_m = border;
      parts.push_back({border, middle, *model});
    }
  }
  if (parts.empty()) return parts;
  parts.back().to_m = profile.ground.back().x;
  return without_slivers(std::move(parts), least_share * length);
}

std::vector<std::string> warnings_of_soils(const Profile& profile,
                                           const std::vector<SoilModel>& soil) {
  if (soil.size() < 2 && soil.front().where.empty()) return {};
  const Along along = walk(profile, soil);
  std::vector<std::string> warnings;
  if (counts(along.without)) {
    warnings.push_back(fmt::format(
        "the section lies with {:.0f} % of it on no soil: there the soil beside it is taken",
        percent(along.without)));
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
