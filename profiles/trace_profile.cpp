#include "profiles/trace_profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "profiles/ground_scale.hpp"
#include "profiles/map_geometry.hpp"

namespace leda::profiles {
namespace {

constexpr double told_bend_degrees = 5;
constexpr double margin_cells = 2;  // of data that must lie beyond crest and toe at missing ground

struct Samples {
  double step_m = 0;
  std::vector<std::optional<double>> elevations;
};

Samples sample(const MapLine& trace, const Dem& dem) {
  const double length = length_of(trace);
  const double length_m = length * dem.info().metres_per_unit;
  const auto steps =
      static_cast<std::size_t>(std::max(1.0, std::ceil(length_m / (0.5 * dem.info().cell_m()))));
  Samples samples{length_m / static_cast<double>(steps), {}};
  samples.elevations.reserve(steps + 1);
  for (std::size_t i = 0; i <= steps; ++i) {
    const double along = length * static_cast<double>(i) / static_cast<double>(steps);
    samples.elevations.push_back(dem.sample(point_at(trace, along)));
  }
  return samples;
}

// Stretches of the trace where every sample holds data, x along the whole trace.
std::vector<Polyline> stretches_with_data(const Samples& samples) {
  std::vector<Polyline> stretches;
  bool open = false;
  for (std::size_t i = 0; i < samples.elevations.size(); ++i) {
    const auto& z = samples.elevations[i];
    if (z && !open) stretches.emplace_back();
    if (z) stretches.back().push_back({samples.step_m * static_cast<double>(i), *z});
    open = z.has_value();
  }
  return stretches;
}

std::optional<Point> on_ground(const std::optional<MapPoint>& by_hand, const LaidSection& section,
                               const Dem& dem, const Polyline& ground) {
  if (!by_hand) return std::nullopt;
  const double x = nearest_on(section.trace, *by_hand).along * dem.info().metres_per_unit;
  return Point{x, elevation_at(ground, x)};
}

bool holds(const Polyline& ground, double x) {
  return ground.front().x <= x && x <= ground.back().x;
}

std::optional<CrestAndToe> bank_of(const Polyline& ground, const LaidSection& section,
                                   const Dem& dem, const TraceOptions& options) {
  const auto crest = on_ground(section.crest, section, dem, ground);
  const auto toe = on_ground(section.toe, section, dem, ground);
  if ((crest && !holds(ground, crest->x)) || (toe && !holds(ground, toe->x))) return std::nullopt;
  if (crest && toe) return CrestAndToe{*crest, *toe};
  // Where a section was laid from its uphill side, the bank on the other side is not meant.
  const Facing facing = section.line >= 0 ? Facing::right : Facing::either;
  auto bank = find_crest_and_toe(ground, options.least_bank_height_m, facing);
  if (!bank) return std::nullopt;
  if (crest) bank->crest = *crest;
  if (toe) bank->toe = *toe;
  if (bank->crest.x == bank->toe.x && bank->crest.z <= bank->toe.z) return std::nullopt;
  return bank;
}

struct Cut {
  Polyline ground;
  CrestAndToe bank;
};

bool is_within(const Cut& cut, double margin_m) {
  const auto [left, right] = std::minmax(cut.bank.crest.x, cut.bank.toe.x);
  return left - cut.ground.front().x >= margin_m && cut.ground.back().x - right >= margin_m;
}

Profile to_profile(const LaidSection& section, const Dem& dem, Cut cut) {
  const double unit = dem.info().metres_per_unit;
  const double start = cut.ground.front().x;
  Profile profile;
  profile.section = section.name;
  profile.trace = piece_of(section.trace, start / unit, cut.ground.back().x / unit);
  for (Point& p : cut.ground) p.x -= start;
  cut.bank.crest.x -= start;
  cut.bank.toe.x -= start;
  profile.ground = std::move(cut.ground);
  profile.bank = cut.bank;
  return profile;
}

/// A DEM shows a face no steeper than one cell allows, and its crest and toe to a cell. Empty where
/// that hardly matters: the bank is some cells wide, or many high.
std::string complaint_of_coarse_cells(const CrestAndToe& bank, const Dem& dem) {
  constexpr double few_cells_wide = 4, few_cells_high = 8;
  const double cell_m = dem.info().cell_m();
  const double width = std::abs(bank.crest.x - bank.toe.x), height = bank.crest.z - bank.toe.z;
  if (width >= few_cells_wide * cell_m || height >= few_cells_high * cell_m) return "";
  return fmt::format(
      "the DEM's cells of {:.3g} m are coarse for a bank {:.1f} m high and {:.1f} m wide: its face "
      "may be steeper than the DEM shows, its crest and toe are known to a cell; cells of at most "
      "{:.2g} m show it",
      cell_m, height, width, std::max(width / few_cells_wide, height / few_cells_high));
}

}  // namespace

Polyline sample_ground(const MapLine& trace, const Dem& dem) {
  Polyline ground;
  for (const Polyline& stretch : stretches_with_data(sample(trace, dem))) {
    ground.insert(ground.end(), stretch.begin(), stretch.end());
  }
  return ground;
}

std::variant<Profile, LeftOut> trace_profile(const LaidSection& section, const Dem& dem,
                                             const TraceOptions& options) {
  const auto leave_out = [&](std::string reason) {
    return LeftOut{section.name, section.trace, std::move(reason)};
  };
  const Samples samples = sample(section.trace, dem);
  const std::vector<Polyline> stretches = stretches_with_data(samples);
  if (stretches.empty())
    return leave_out("the DEM holds no data along the section" + note_on_missing(dem.info()));
  const bool whole = stretches.size() == 1 && stretches[0].size() == samples.elevations.size();

  const double margin_m = margin_cells * dem.info().cell_m();
  std::optional<Cut> best;
  bool bank_cut_off = false;
  for (const Polyline& stretch : stretches) {
    if (stretch.size() < 2) continue;
    Cut cut{simplify(stretch, options.tolerance_m), {}};
    const auto bank = bank_of(cut.ground, section, dem, options);
    if (!bank) continue;
    cut.bank = *bank;
    if (!whole && !is_within(cut, margin_m)) {
      bank_cut_off = true;
      continue;
    }
    const auto length = [](const Cut& c) { return c.ground.back().x - c.ground.front().x; };
    if (!best || length(cut) > length(*best)) best = std::move(cut);
  }
  if (!best && bank_cut_off) {
    return leave_out("the DEM holds no data at the crest or the toe of the bank" +
                     note_on_missing(dem.info()));
  }
  if (!best) {
    return leave_out(fmt::format("the ground has no bank of at least {:g} m{}",
                                 options.least_bank_height_m,
                                 whole ? "" : " where the DEM holds data") +
                     (whole ? "" : note_on_missing(dem.info())));
  }

  const double from = best->ground.front().x, to = best->ground.back().x;
  const double length_m = length_of(section.trace) * dem.info().metres_per_unit;
  const bool reaches_end = !is_within(*best, margin_m);
  Profile profile = to_profile(section, dem, std::move(*best));
  if (!whole) {
    profile.warnings.push_back(
        fmt::format("shortened to {:.1f} - {:.1f} m of its {:.1f} m where the DEM holds data{}",
                    from, to, length_m, note_on_missing(dem.info())));
  }
  if (const Bend bend = greatest_bend(profile.trace); bend.degrees > told_bend_degrees) {
    profile.warnings.push_back(fmt::format(
        "the line turns {:.0f} degrees off its way at ({:.2f}, {:.2f}): it is simulated as if it "
        "were straight, its lengths as along the line",
        bend.degrees, bend.at.x, bend.at.y));
  }
  const std::string complaint =
      GroundScale(dem.info().epsg)
          .complaint_at(point_at(profile.trace, length_of(profile.trace) / 2), told_departure);
  if (!complaint.empty()) {
    profile.warnings.push_back(fmt::format("EPSG:{}: {}", dem.info().epsg, complaint));
  }
  if (auto coarse = complaint_of_coarse_cells(profile.bank, dem); !coarse.empty()) {
    profile.warnings.push_back(std::move(coarse));
  }
  if (reaches_end) {
    profile.warnings.emplace_back(
        "the bank reaches the end of the section: a longer section may slide further");
  }
  return profile;
}

Polyline simplify(const Polyline& line, double tolerance_m) {
  if (line.size() < 3) return line;
  std::vector<bool> kept(line.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, line.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    const double slope = (line[last].z - line[first].z) / (line[last].x - line[first].x);
    std::size_t farthest = first;
    double largest = tolerance_m;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double off = std::abs(line[i].z - line[first].z - slope * (line[i].x - line[first].x));
      if (off > largest) {
        largest = off;
        farthest = i;
      }
    }
    if (farthest == first) continue;
    kept[farthest] = true;
    open.emplace_back(first, farthest);
    open.emplace_back(farthest, last);
  }
  Polyline result;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (kept[i]) result.push_back(line[i]);
  }
  return result;
}

}  // namespace leda::profiles
