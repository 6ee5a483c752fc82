#pragma once
// Ensembles as a drawing: how probable it is that a distance is exceeded.

#include <string>
#include <vector>

#include "server/documents/ensemble_document.hpp"

namespace leda::server {

/// A panel a distance with a curve and its interval for each section, and the quantiles with their
/// ranges by ranks; of a single section, below them, which input decides how much. SVG 1.1,
/// self-contained.
std::string ensemble_svg(const std::vector<SectionEnsemble>& sections);

}  // namespace leda::server
