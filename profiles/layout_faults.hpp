#pragma once
// Every fault of a layout, before anything is laid.

#include <vector>

#include "profiles/dem.hpp"
#include "profiles/lay_out_sections.hpp"

namespace leda::profiles {

std::vector<Fault> faults_of(const SectionLayout& layout, const Dem& dem,
                             const LayoutLimits& limits);

}  // namespace leda::profiles
