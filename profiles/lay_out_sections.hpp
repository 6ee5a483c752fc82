#pragma once
// A layout (named lines, or a spacing along a line) to the traces of sections on a DEM.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "profiles/dem.hpp"
#include "profiles/map/section_layout.hpp"
#include "solver/section/validate.hpp"

namespace leda::profiles {

struct LaidSection {
  std::string name;
  int line = -1;     ///< sections of one line are neighbours; named lines: -1
  double order = 0;  ///< position along the line, m
  MapLine trace;     ///< from the uphill side downhill and across
  std::optional<MapPoint> crest = std::nullopt;  ///< given by hand, on the trace
  std::optional<MapPoint> toe = std::nullopt;
};

struct LayoutLimits {
  std::size_t most_sections = 2000;
  double least_length_m = 20;  ///< of a section and of a line sections are laid along
  double longest_m = 5000;     ///< of a section
  double least_spacing_m = 1;
};

/// Sections to cut, or every fault of the layout; never both. Pointers are relative to the
/// layout: "/lines/0/line/1", "/along/0/spacing_m".
struct Layout {
  std::vector<LaidSection> sections;
  std::vector<Fault> faults;
};

/// Named lines keep their place and are turned round where their bank descends towards their
/// start. They must lie on data over their whole length. Sections along a line are laid across the
/// line smoothed over two spacings, at spacing/2, 3 spacing/2, ... of it and perpendicular to it.
/// Uphill is the side where the ground is higher on average; where the two differ by less than
/// 0.5 m, as the nearest section has it that differs more.
Layout lay_out_sections(const SectionLayout& layout, const Dem& dem,
                        const LayoutLimits& limits = {});

}  // namespace leda::profiles
