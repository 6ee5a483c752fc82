#pragma once
// Pieces of SVG 1.1 that every drawing is made of. Lengths are pixels.

#include <string>

namespace leda::server {

/// Text as it may stand in an element or an attribute.
std::string escaped(const std::string& text);

/// @param anchor "start", "middle" or "end"
/// @param style further attributes, beginning with a space
std::string text_at(double x, double y, const char* anchor, const std::string& text,
                    const char* style = "");

/// @param style attributes
std::string line(double x1, double y1, double x2, double y2, const std::string& style);

/// A step of 1, 2 or 5 times a power of ten that divides a range into about five.
double tick_step(double range);

}  // namespace leda::server
