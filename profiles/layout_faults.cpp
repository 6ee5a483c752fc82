#include "profiles/layout_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "profiles/ground_scale.hpp"
#include "profiles/map_geometry.hpp"
#include "profiles/sections_along.hpp"

namespace leda::profiles {
namespace {

constexpr std::size_t most_points =
    10'000;  // of one line; looking for crossings costs their square
constexpr std::size_t longest_name = 100;
constexpr double most_bend_degrees = 45;
constexpr double farthest_by_hand_m = 50;  // of a crest or toe given by hand from its line

std::string text_of(MapPoint p) { return fmt::format("({:.2f}, {:.2f})", p.x, p.y); }

std::string text_of(const MapBox& box) {
  return fmt::format("x {:.2f} to {:.2f}, y {:.2f} to {:.2f}", box[0], box[2], box[1], box[3]);
}

class Checker {
 public:
  Checker(const Dem& dem, const LayoutLimits& limits)
      : dem_(dem), limits_(limits), scale_(dem.info().epsg) {}

  void add(std::string pointer, std::string message) {
    faults.push_back({std::move(pointer), std::move(message)});
  }

  // Whether the line is sound enough to be walked along.
  bool check_line(const MapLine& line, const std::string& pointer) {
    const std::size_t before = faults.size();
    if (line.size() < 2 || line.size() > most_points) {
      add(pointer, fmt::format("has {} points, a line has 2 to {}", line.size(), most_points));
      return false;
    }
    check_points(line, pointer);
    if (faults.size() != before) return false;
    if (const auto crossing = first_self_crossing(line)) {
      add(pointer, "crosses itself at " + text_of(*crossing) + ": a line must not");
    }
    check_scale(line, pointer);
    const double length = length_of(line) * dem_.info().metres_per_unit;
    if (length < limits_.least_length_m) {
      add(pointer, fmt::format("is {:.2f} m long, it must be at least {:g} m", length,
                               limits_.least_length_m));
    }
    return faults.size() == before;
  }

  void check_positive(double value, const std::string& pointer) {
    if (!std::isfinite(value) || value <= 0) {
      add(pointer, fmt::format("is {:g}, it must be a positive number of metres", value));
    }
  }

  void check_named(const NamedLine& named, const std::string& pointer) {
    check_name(named.name, pointer + "/name");
    if (!check_line(named.line, pointer + "/line")) return;
    const double length = length_of(named.line) * dem_.info().metres_per_unit;
    if (length > limits_.longest_m) {
      add(pointer + "/line", fmt::format("is {:.0f} m long, a section is at most {:g} m long",
                                         length, limits_.longest_m));
      return;
    }
    check_straight(named.line, pointer + "/line");
    check_has_data(named.line, pointer + "/line");
    check_by_hand(named, pointer);
  }

  // Returns how many sections the line asks for, 0 where that can't be said.
  double check_along(const SectionsAlong& along, const std::string& pointer) {
    const std::size_t before = faults.size();
    check_positive(along.spacing_m, pointer + "/spacing_m");
    check_positive(along.upslope_m, pointer + "/upslope_m");
    check_positive(along.downslope_m, pointer + "/downslope_m");
    if (faults.size() == before) {
      const double length = along.upslope_m + along.downslope_m;
      if (length > limits_.longest_m || length < limits_.least_length_m) {
        add(pointer + "/upslope_m",
            fmt::format("with downslope_m gives sections {:g} m long, they may be {:g} to {:g} m",
                        length, limits_.least_length_m, limits_.longest_m));
      }
      if (along.spacing_m < limits_.least_spacing_m) {
        add(pointer + "/spacing_m", fmt::format("is {:g}, it must be at least {:g} m",
                                                along.spacing_m, limits_.least_spacing_m));
      }
    }
    const bool sizes_sound = faults.size() == before;
    if (!check_line(along.along, pointer + "/along") || !sizes_sound) return 0;
    return count_along(length_of(along.along) * dem_.info().metres_per_unit, along.spacing_m);
  }

  void take_name(const std::string& name, const std::string& pointer) {
    if (!names_.insert(name).second) {
      add(pointer, "'" + name + "' is the name of another section: names must differ");
    }
  }

  std::vector<Fault> faults;

 private:
  void check_name(const std::string& name, const std::string& pointer) {
    const bool printable = std::none_of(name.begin(), name.end(), [](unsigned char c) {
      return c < 0x20 || c == 0x7f || c == '/' || c == '\\';
    });
    if (name.empty() || name.size() > longest_name || !printable) {
      add(pointer, fmt::format("must be 1 to {} characters, without slashes or control characters",
                               longest_name));
      return;
    }
    take_name(name, pointer);
  }

  // What a point outside the DEM was probably meant to be.
  std::string meant_by(MapPoint p) const {
    if (dem_.contains({p.y, p.x})) {
      return ": with its numbers the other way round it lies inside; give easting, then northing";
    }
    if (std::abs(p.x) <= 180 && std::abs(p.y) <= 180) {
      return ": if these are degrees, give coordinates of the DEM's CRS instead";
    }
    return "";
  }

  void check_points(const MapLine& line, const std::string& pointer) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const std::string at = fmt::format("{}/{}", pointer, i);
      if (!std::isfinite(line[i].x) || !std::isfinite(line[i].y)) {
        add(at, "is not a pair of finite numbers");
      } else if (!dem_.contains(line[i])) {
        add(at, text_of(line[i]) + " lies outside the DEM (" + text_of(dem_.info().box) +
                    fmt::format(", EPSG:{})", dem_.info().epsg) + meant_by(line[i]));
      }
    }
  }

  // A section is one plane. What turns further off its way than this has no such plane; a smaller
  // bend is a warning (trace_profile.cpp).
  void check_straight(const MapLine& line, const std::string& pointer) {
    if (line.front() == line.back()) {
      add(pointer, "is a ring: a section runs from one side of a bank to the other");
      return;
    }
    const Bend bend = greatest_bend(line);
    if (bend.degrees <= most_bend_degrees) return;
    add(pointer, fmt::format("turns {:.0f} degrees off its way at {}, at most {:g} are allowed: a "
                             "section is one vertical plane, draw it straight across the bank",
                             bend.degrees, text_of(bend.at), most_bend_degrees));
  }

  // Told once: all of a region lies in one system.
  void check_scale(const MapLine& line, const std::string& pointer) {
    if (scale_told_) return;
    const std::string complaint =
        scale_.complaint_at(point_at(line, length_of(line) / 2), most_departure);
    if (complaint.empty()) return;
    add(pointer, fmt::format("lies where EPSG:{} is stretched: {}", dem_.info().epsg, complaint));
    scale_told_ = true;
  }

  void check_has_data(const MapLine& line, const std::string& pointer) {
    const double unit = dem_.info().metres_per_unit;
    const double length = length_of(line);
    const auto steps =
        static_cast<std::size_t>(std::ceil(length * unit / (0.5 * dem_.info().cell_m())));
    std::optional<double> first, last;
    for (std::size_t i = 0; i <= steps; ++i) {
      const double along = length * static_cast<double>(i) / static_cast<double>(steps);
      if (dem_.sample(point_at(line, along))) continue;
      if (!first) first = along;
      last = along;
    }
    if (!first) return;
    add(pointer, fmt::format("runs over ground without data from {:.1f} m {} to {:.1f} m {} of its "
                             "length: move or shorten it{}",
                             *first * unit, text_of(point_at(line, *first)), *last * unit,
                             text_of(point_at(line, *last)), note_on_missing(dem_.info())));
  }

  void check_by_hand(const NamedLine& named, const std::string& pointer) {
    const std::size_t before = faults.size();
    const auto check = [&](const std::optional<MapPoint>& point, const char* what) {
      if (!point) return;
      const double away = nearest_on(named.line, *point).distance * dem_.info().metres_per_unit;
      if (std::isfinite(away) && away <= farthest_by_hand_m) return;
      add(pointer + what,
          fmt::format("{} is {:.1f} m away from the line, at most {:g} m is allowed",
                      text_of(*point), away, farthest_by_hand_m));
    };
    check(named.crest, "/crest");
    check(named.toe, "/toe");
    if (!named.crest || !named.toe || faults.size() != before) return;
    const double apart = std::abs(nearest_on(named.line, *named.crest).along -
                                  nearest_on(named.line, *named.toe).along);
    if (apart == 0) add(pointer + "/toe", "lies on the crest: they must differ");
  }

  const Dem& dem_;
  const LayoutLimits& limits_;
  GroundScale scale_;
  bool scale_told_ = false;
  std::set<std::string> names_;
};

}  // namespace

std::vector<Fault> faults_of(const SectionLayout& layout, const Dem& dem,
                             const LayoutLimits& limits) {
  Checker checker(dem, limits);
  if (layout.lines.empty() && layout.along.empty()) {
    checker.add("", "asks for no section: give named lines, or a line with a spacing");
  }
  auto count = static_cast<double>(layout.lines.size());
  for (std::size_t i = 0; i < layout.along.size(); ++i) {
    const double along = checker.check_along(layout.along[i], fmt::format("/along/{}", i));
    // The names these sections will get; a count beyond the limit is reported below.
    if (count + along <= static_cast<double>(limits.most_sections)) {
      const double first = count - static_cast<double>(layout.lines.size());
      for (int n = 1; n <= static_cast<int>(along); ++n) {
        checker.take_name(fmt::format("S{:03}", static_cast<int>(first) + n),
                          fmt::format("/along/{}", i));
      }
    }
    count += along;
  }
  if (count > static_cast<double>(limits.most_sections)) {
    checker.add("", fmt::format("asks for {:.0f} sections, at most {} are allowed: widen the "
                                "spacing, or split the region",
                                count, limits.most_sections));
    return checker.faults;
  }
  for (std::size_t i = 0; i < layout.lines.size(); ++i) {
    checker.check_named(layout.lines[i], fmt::format("/lines/{}", i));
  }
  return checker.faults;
}

}  // namespace leda::profiles
