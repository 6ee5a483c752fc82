#pragma once
// A hindcast as a drawing.

#include <string>

#include "server/documents/hindcast_document.hpp"

namespace leda::server {

/// The distribution of each shared input before and after; below, each slide's distances as the
/// others predict them beside what was observed. SVG 1.1, self-contained.
std::string hindcast_svg(const Hindcast& hindcast);

}  // namespace leda::server
