#include "profiles/lay_out_sections.hpp"

#include <algorithm>

#include "profiles/layout_faults.hpp"
#include "profiles/map_geometry.hpp"
#include "profiles/sections_along.hpp"
#include "profiles/trace_profile.hpp"

namespace leda::profiles {
namespace {

// By the bank given by hand, else by the bank the ground shows, else by the height of the ends.
bool runs_uphill(const LaidSection& section, const Dem& dem) {
  if (section.crest && section.toe) {
    return nearest_on(section.trace, *section.crest).along >
           nearest_on(section.trace, *section.toe).along;
  }
  const Polyline ground = sample_ground(section.trace, dem);
  if (const auto bank = find_crest_and_toe(ground)) return bank->crest.x > bank->toe.x;
  return ground.front().z < ground.back().z;
}

LaidSection lay_named(const NamedLine& named, const Dem& dem) {
  LaidSection section;
  section.name = named.name;
  section.trace = named.line;
  section.crest = named.crest;
  section.toe = named.toe;
  if (runs_uphill(section, dem)) std::reverse(section.trace.begin(), section.trace.end());
  return section;
}

}  // namespace

Layout lay_out_sections(const SectionLayout& layout, const Dem& dem, const LayoutLimits& limits) {
  Layout laid;
  laid.faults = faults_of(layout, dem, limits);
  if (!laid.faults.empty()) return laid;
  for (const NamedLine& named : layout.lines) laid.sections.push_back(lay_named(named, dem));
  int next = 1;
  for (std::size_t i = 0; i < layout.along.size(); ++i) {
    for (LaidSection& section : lay_along(layout.along[i], static_cast<int>(i), next, dem)) {
      laid.sections.push_back(std::move(section));
    }
    next = 1 + static_cast<int>(laid.sections.size() - layout.lines.size());
  }
  return laid;
}

}  // namespace leda::profiles
