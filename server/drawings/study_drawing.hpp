#pragma once
// A study as a drawing: error over run time.

#include <string>

#include "server/documents/study_document.hpp"

namespace leda::server {

/// A panel for each distance that is compared, both axes logarithmic, one mark a setting: coloured
/// by cell size, shaped by particles per cell, as large as the time step is long, whiskers from the
/// least to the largest value over seeds, hollow where the setting is never named, ringed where it
/// is the fastest within the wanted error. An error of 0 stands on the lower axis. SVG 1.1,
/// self-contained.
std::string study_svg(const Study& study);

}  // namespace leda::server
