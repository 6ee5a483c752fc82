// The comparison as a drawing. One scale for all panels and both directions, so that lengths and
// slopes can be read off and compared by eye; x of each panel is measured from its own toe.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "server/documents/compare_document.hpp"
#include "server/drawings/svg.hpp"

namespace leda::server {
namespace {

constexpr double drawing_width = 1200;
constexpr double margin_left = 64, margin_right = 24;
constexpr double title_height = 48;   ///< above each panel's axes
constexpr double axis_height = 40;    ///< below them
constexpr double legend_height = 44;  ///< once, at the top
constexpr double least_panel = 120;

constexpr const char* before_colour = "#8a6d3b";
constexpr const char* after_colour = "#1f5fa8";

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void add(double v) {
    if (!std::isfinite(v)) return;
    low = std::min(low, v);
    high = std::max(high, v);
  }
  double size() const { return high - low; }
};

/// From metres to the drawing; x grows to the right, z upwards.
struct Scale {
  double pixels_per_m = 1;
  double left_m = 0;  ///< x at the left edge of the axes
  double bottom_m = 0;
  double bottom = 0;  ///< y of the lower axis in the drawing
  double toe_x = 0;   ///< where x counts from
  double x(double metres) const { return margin_left + (metres - toe_x - left_m) * pixels_per_m; }
  double y(double metres) const { return bottom - (metres - bottom_m) * pixels_per_m; }
};

std::string path(const Polyline& points, const Scale& scale, const char* style) {
  std::string d;
  for (const Point& p : points) {
    if (!std::isfinite(p.x) || !std::isfinite(p.z)) continue;
    d += fmt::format("{}{:.2f} {:.2f} ", d.empty() ? 'M' : 'L', scale.x(p.x), scale.y(p.z));
  }
  return d.empty() ? "" : fmt::format("<path d=\"{}\" fill=\"none\" {}/>\n", d, style);
}

/// 1, 2 or 5 times a power of ten, so that about `count` steps cover the size.
double round_step(double size, double count) {
  const double rough = std::max(size / count, 1e-6);
  const double power = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough) return factor * power;
  }
  return 10 * power;
}

/// Marks stand on stems of different lengths, so that names of close points stay apart; a negative
/// one hangs below the point, where the debris is not drawn.
std::string mark(const Scale& scale, Point p, const char* name, double stem, const char* colour) {
  if (!std::isfinite(p.x) || !std::isfinite(p.z)) return "";
  const double x = scale.x(p.x), y = scale.y(p.z);
  const std::string style = fmt::format("stroke=\"{}\" stroke-width=\"1\"", colour);
  return line(x, y, x, y - stem, style.c_str()) +
         fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"{}\"/>\n", x, y, colour) +
         text_at(x, y - stem + (stem > 0 ? -4 : 13), "middle", name,
                 fmt::format(" fill=\"{}\"", colour).c_str());
}

std::string heading(const ComparedSection& s) {
  if (!s.result) return fmt::format("{}: {}, not simulated", s.name, s.state);
  const auto at_least = [](Bound is) { return is == Bound::lower_bound ? "at least " : ""; };
  return fmt::format("{}: {}, retrogression {}{:.1f} m, runout {}{:.1f} m", s.name,
                     to_string(s.result->status), at_least(s.result->retrogression_is),
                     s.result->crest_to_crest_retrogression_m, at_least(s.result->runout_is),
                     s.result->runout_m);
}

struct Extent {
  Range x;  ///< from the toe, m
  Range z;
};

Extent extent_of(const ComparedSection& s) {
  Extent e;
  const auto add = [&](Point p) {
    e.x.add(p.x - s.toe.x);
    e.z.add(p.z);
  };
  for (const Point& p : s.ground) add(p);
  if (s.result) {
    for (const Point& p : s.result->profile_after) add(p);
  }
  add(s.crest);
  add(s.toe);
  return e;
}

std::vector<double> multiples(double step, double least, double most) {
  std::vector<double> values;
  const auto first = static_cast<long>(std::ceil(least / step));
  const auto last = static_cast<long>(std::floor(most / step));
  for (long i = first; i <= last; ++i) values.push_back(static_cast<double>(i) * step);
  return values;
}

std::string axes(const Scale& scale, const Range& x, double top_m, double top) {
  const double right = margin_left + x.size() * scale.pixels_per_m;
  std::string out = fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"#ffffff\" "
      "stroke=\"#999999\"/>\n",
      margin_left, top, right - margin_left, scale.bottom - top);
  const char* grid = "stroke=\"#e4e4e4\"";
  const double step_x = round_step(x.size(), 12);
  for (const double v : multiples(step_x, x.low, x.high)) {
    const double at = scale.x(v + scale.toe_x);
    out += line(at, top, at, scale.bottom, grid);
    out += text_at(at, scale.bottom + 16, "middle", fmt::format("{:.6g}", v));
  }
  const double step_z = round_step((scale.bottom - top) / scale.pixels_per_m,
                                   std::clamp((scale.bottom - top) / 30, 2.0, 8.0));
  for (const double v : multiples(step_z, scale.bottom_m, top_m)) {
    out += line(margin_left, scale.y(v), right, scale.y(v), grid);
    out += text_at(margin_left - 6, scale.y(v) + 4, "end", fmt::format("{:.6g}", v));
  }
  out +=
      text_at((margin_left + right) / 2, scale.bottom + 33, "middle", "distance from the toe (m)");
  const double middle = (top + scale.bottom) / 2;
  out += fmt::format(
      "<text x=\"16\" y=\"{0:.1f}\" text-anchor=\"middle\" transform=\"rotate(-90 "
      "16 {0:.1f})\">elevation (m)</text>\n",
      middle);
  return out;
}

std::string panel(const ComparedSection& s, const Scale& scale, const Range& x, double top_m,
                  double top) {
  std::string out =
      text_at(margin_left, top - 14, "start", heading(s), " font-size=\"15\" font-weight=\"bold\"");
  out += axes(scale, x, top_m, top);
  out +=
      path(s.ground, scale,
           fmt::format("stroke=\"{}\" stroke-width=\"2\" stroke-dasharray=\"6 3\"", before_colour)
               .c_str());
  if (s.result) {
    out += path(s.result->profile_after, scale,
                fmt::format("stroke=\"{}\" stroke-width=\"2\"", after_colour).c_str());
  }
  out += mark(scale, s.crest, "crest", 14, before_colour);
  out += mark(scale, s.toe, "toe", -8, before_colour);
  if (s.result && s.result->status != RunStatus::stable) {
    out += mark(scale, s.result->backscarp, "backscarp", 32, after_colour);
    out += mark(scale, s.result->front, "front", 32, after_colour);
  }
  return out;
}

std::string legend() {
  const auto entry = [](double x, const char* style, const char* name) {
    return line(x, 22, x + 36, 22, style) + text_at(x + 44, 26, "start", name);
  };
  return entry(
             margin_left,
             fmt::format("stroke=\"{}\" stroke-width=\"2\" stroke-dasharray=\"6 3\"", before_colour)
                 .c_str(),
             "ground before, with crest and toe") +
         entry(margin_left + 320,
               fmt::format("stroke=\"{}\" stroke-width=\"2\"", after_colour).c_str(),
               "ground after, with backscarp and front");
}

}  // namespace

std::string compare_svg(const std::vector<ComparedSection>& sections) {
  Extent all;
  std::vector<Extent> extents;
  for (const ComparedSection& s : sections) {
    extents.push_back(extent_of(s));
    all.x.add(extents.back().x.low);
    all.x.add(extents.back().x.high);
  }
  const double pixels_per_m =
      (drawing_width - margin_left - margin_right) / std::max(all.x.size(), 1e-6);
  constexpr double headroom = 52;  // for the marks above the highest ground
  constexpr double footroom = 30;  // and for the toe below the lowest
  std::string body;
  double top = legend_height;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    top += title_height;
    const Range& z = extents[i].z;
    const double height =
        std::max(std::max(z.size(), 0.0) * pixels_per_m + headroom + footroom, least_panel);
    Scale scale;
    scale.pixels_per_m = pixels_per_m;
    scale.left_m = all.x.low;
    scale.toe_x = sections[i].toe.x;
    scale.bottom = top + height;
    scale.bottom_m = z.low - footroom / pixels_per_m;
    const double top_m = scale.bottom_m + height / pixels_per_m;
    body += panel(sections[i], scale, all.x, top_m, top);
    top += height + axis_height;
  }
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
             "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\" font-size=\"12\" "
             "fill=\"#222222\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fafafa\"/>\n",
             drawing_width, top + 12) +
         legend() + body + "</svg>\n";
}

}  // namespace leda::server
