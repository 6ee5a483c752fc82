#include "server/drawings/curve_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "server/drawings/svg.hpp"

namespace leda::server {
namespace {

constexpr double width = 460, height = 300, left = 60, top = 50, gap = 80;
constexpr std::array colors{"#1b4965", "#c1121f", "#2a9d8f", "#e09f3e"};

struct Panel {
  double x0 = 0;  ///< left edge, px
  bool logarithmic = false;
  double least = 0, most = 1;  ///< strain, percent
  double top_kPa = 1;

  double x(double percent) const {
    const double t = logarithmic ? std::log(percent / least) / std::log(most / least)
                                 : (percent - least) / (most - least);
    return x0 + width * t;
  }
  double y(double kPa) const { return top + height * (1 - kPa / top_kPa); }
};

std::vector<double> strain_ticks(const Panel& panel) {
  std::vector<double> ticks;
  if (panel.logarithmic) {
    const int first = static_cast<int>(std::ceil(std::log10(panel.least) - 1e-9));
    const int last = static_cast<int>(std::floor(std::log10(1.001 * panel.most)));
    for (int decade = first; decade <= last; ++decade) ticks.push_back(std::pow(10, decade));
  } else {
    const double step = tick_step(panel.most);
    for (int i = 0; i * step <= 1.001 * panel.most; ++i) ticks.push_back(i * step);
  }
  return ticks;
}

void draw_axes(std::string& svg, const Panel& panel) {
  auto out = std::back_inserter(svg);
  fmt::format_to(out,
                 "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.0f}\" height=\"{:.0f}\" fill=\"none\" "
                 "stroke=\"#444\"/>\n",
                 panel.x0, top, width, height);
  for (const double t : strain_ticks(panel)) {
    fmt::format_to(out,
                   "<path d=\"M{0:.1f} {1:.1f}V{2:.1f}\" stroke=\"#ddd\"/><text x=\"{0:.1f}\" "
                   "y=\"{3:.1f}\" text-anchor=\"middle\">{4:g}</text>\n",
                   panel.x(t), top, top + height, top + height + 16, t);
  }
  const double step = tick_step(panel.top_kPa);
  for (int i = 0; i * step <= 1.001 * panel.top_kPa; ++i) {
    fmt::format_to(out,
                   "<path d=\"M{0:.1f} {1:.1f}h{2:.0f}\" stroke=\"#ddd\"/><text x=\"{3:.1f}\" "
                   "y=\"{4:.1f}\" text-anchor=\"end\">{5:g}</text>\n",
                   panel.x0, panel.y(i * step), width, panel.x0 - 6, panel.y(i * step) + 4,
                   i * step);
  }
  fmt::format_to(out,
                 "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">shear strain, %{}</text>\n"
                 "<text transform=\"translate({:.1f},{:.1f}) rotate(-90)\" "
                 "text-anchor=\"middle\">shear stress, kPa</text>\n",
                 panel.x0 + width / 2, top + height + 34, panel.logarithmic ? " (log)" : "",
                 panel.x0 - 42, top + height / 2);
}

void draw_curve(std::string& svg, const Panel& panel, const DrawnCurve& curve, const char* color) {
  auto out = std::back_inserter(svg);
  std::string path;
  for (std::size_t i = 0; i < curve.strain.size(); ++i) {
    const double percent = 100 * curve.strain[i];
    if (percent < panel.least) continue;
    const double x = panel.x(percent);
    const double y = panel.y(curve.stress_Pa[i] / 1000);
    if (curve.as_points) {
      fmt::format_to(out, "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\" fill=\"{}\"/>\n", x, y,
                     color);
    } else {
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L', x, y);
    }
  }
  if (!path.empty()) {
    fmt::format_to(out, "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"/>\n", path,
                   color);
  }
}

}  // namespace

std::string draw_curves(const std::string& title, const std::vector<DrawnCurve>& curves) {
  double most = 1e-6, top_kPa = 1e-6;
  for (const auto& curve : curves) {
    for (const double s : curve.strain) most = std::max(most, 100 * s);
    for (const double s : curve.stress_Pa) top_kPa = std::max(top_kPa, s / 1000);
  }
  const Panel linear{left, false, 0, most, 1.1 * top_kPa};
  const Panel log{left + width + gap, true, std::min(0.1, most / 10), most, 1.1 * top_kPa};
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" "
      "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" "
      "fill=\"#fff\"/>\n<text x=\"{:.0f}\" y=\"20\" font-size=\"15\">{}</text>\n",
      log.x0 + width + 30, top + height + 50, left, escaped(title));
  double x = left;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const char* color = colors[i % colors.size()];
    svg += fmt::format("<text x=\"{:.0f}\" y=\"40\" fill=\"{}\">{} {}</text>\n", x, color,
                       curves[i].as_points ? "\u2022" : "\u2014", escaped(curves[i].label));
    x += 30 + 7.5 * static_cast<double>(curves[i].label.size());
  }
  for (const Panel& panel : {linear, log}) {
    draw_axes(svg, panel);
    for (std::size_t i = 0; i < curves.size(); ++i) {
      draw_curve(svg, panel, curves[i], colors[i % colors.size()]);
    }
  }
  return svg + "</svg>\n";
}

}  // namespace leda::server
