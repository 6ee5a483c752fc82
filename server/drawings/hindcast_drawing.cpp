#include "server/drawings/hindcast_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "server/drawings/svg.hpp"

namespace leda::server {
namespace {

using solver::Distance;

constexpr double left = 30, panel_width = 260, panel_height = 130, between = 40;
constexpr int panels_a_row = 3;
constexpr double panels_top = 70, panel_step = panel_height + 62;
constexpr double names_width = 250, row_height = 24, margin = 24;
constexpr double whole_width = left + panels_a_row * (panel_width + between);
constexpr const char* before = "#888";
constexpr const char* after = "#b2182b";
constexpr const char* muted = " fill=\"#555\"";

/// Cumulated weights by value, as a step line in a panel.
std::string steps(const std::vector<double>& values, const std::vector<double>& weights, double x0,
                  double y0, const char* colour) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return values[i]; });
  const double low = values[order.front()], range = values[order.back()] - low;
  double sum = 0;
  std::string d = fmt::format("M{:.1f} {:.1f}", x0, y0 + panel_height);
  for (const std::size_t i : order) {
    sum += weights[i];
    const double x = x0 + (range > 0 ? panel_width * (values[i] - low) / range : 0);
    d += fmt::format("H{:.1f}V{:.1f}", x, y0 + panel_height * (1 - sum));
  }
  return fmt::format("<path d=\"{}H{:.1f}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.8\"/>\n",
                     d, x0 + panel_width, colour);
}

std::string input_panel(const Hindcast& h, std::size_t shown, double x0, double y0) {
  const auto& shift = h.summary.inputs[shown];
  std::vector<double> values;
  for (std::size_t m = 0; m < h.summary.members; ++m) {
    values.push_back(h.asked.inputs_of(h.draws, {0, m, 0})[shift.input]);
  }
  const auto [low, high] = std::ranges::minmax(values);
  std::string out = fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.0f}\" height=\"{:.0f}\" fill=\"none\" "
      "stroke=\"#444\"/>\n",
      x0, y0, panel_width, panel_height);
  out += text_at(
      x0, y0 - 8, "start",
      fmt::format("{}: moved by {:+.2f} sd, {:.2f} as wide",
                  h.asked.plan.draws.inputs[shift.input].name, shift.shift, shift.narrowing));
  out += steps(values, h.summary.prior.values, x0, y0, before);
  out += steps(values, h.summary.posterior.values, x0, y0, after);
  out += text_at(x0, y0 + panel_height + 16, "start", fmt::format("{:.3g}", low));
  return out +
         text_at(x0 + panel_width, y0 + panel_height + 16, "end", fmt::format("{:.3g}", high));
}

/// Distances in a logarithmic scale that holds all of them.
struct Scale {
  double low_m = std::numeric_limits<double>::infinity(), high_m = 0;
  void hold(double metres) {
    low_m = std::min(low_m, metres);
    high_m = std::max(high_m, metres);
  }
  double x(double metres) const {
    const double part = std::log(metres / low_m) / std::log(high_m / low_m);
    return left + names_width + (whole_width - left - names_width - margin) * part;
  }
};

Scale scale_of(const Hindcast& h) {
  Scale scale;
  for (std::size_t e = 0; e < h.summary.slides.size(); ++e) {
    for (const auto& [distance, p] : h.summary.slides[e].by_distance) {
      const auto& seen = *solver::observed_of(h.asked.plan.slides[e], distance);
      for (const auto& metres : {std::optional(p.low_m), std::optional(p.median_m), p.high_m,
                                 seen.value_m, seen.at_least_m, seen.at_most_m}) {
        if (metres) scale.hold(*metres);
      }
    }
  }
  if (scale.high_m == 0) scale = {1, 1000};
  scale.low_m /= 1.2;
  scale.high_m *= 1.5;
  return scale;
}

std::string observed_mark(const Scale& scale, const solver::Observed& seen, double y) {
  const std::string style = "stroke=\"#000\" stroke-width=\"2\"";
  if (seen.value_m) {
    const double x = scale.x(*seen.value_m);
    return line(x - 5, y - 5, x + 5, y + 5, style) + line(x - 5, y + 5, x + 5, y - 5, style);
  }
  const double from = scale.x(seen.at_least_m.value_or(scale.low_m));
  const double to = scale.x(seen.at_most_m.value_or(scale.high_m));
  return line(from, y + 7, to, y + 7, style);
}

std::string slide_row(const Hindcast& h, const Scale& scale, std::size_t e, Distance distance,
                      double y) {
  const auto& slide = h.asked.plan.slides[e];
  const auto& p = h.summary.slides[e].by_distance.at(distance);
  std::string out =
      text_at(left + names_width - 12, y + 4, "end", slide.name + ", " + to_string(distance));
  const double end = p.high_m ? scale.x(*p.high_m) : scale.x(scale.high_m);
  out += line(scale.x(p.low_m), y, end, y, fmt::format("stroke=\"{}\" stroke-width=\"3\"", after));
  if (!p.high_m) out += text_at(end + 4, y + 5, "start", "\u2192");
  out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.5\" fill=\"{}\"/>\n",
                     scale.x(p.median_m), y, after);
  return out + observed_mark(scale, *solver::observed_of(slide, distance), y);
}

std::string distance_axis(const Scale& scale, double top, double bottom) {
  std::string out;
  for (int decade = 0; decade <= 5; ++decade) {
    for (const double times : {1.0, 2.0, 5.0}) {
      const double metres = times * std::pow(10, decade);
      if (metres < scale.low_m || metres > scale.high_m) continue;
      out += line(scale.x(metres), top, scale.x(metres), bottom, "stroke=\"#ddd\"");
      out += text_at(scale.x(metres), bottom + 16, "middle", fmt::format("{:g}", metres));
    }
  }
  return out + text_at(scale.x(std::sqrt(scale.low_m * scale.high_m)), bottom + 34, "middle",
                       "distance, m");
}

std::string slides_panel(const Hindcast& h, double top, double* bottom) {
  const Scale scale = scale_of(h);
  std::string rows;
  double y = top + row_height;
  for (std::size_t e = 0; e < h.summary.slides.size(); ++e) {
    for (const auto& [distance, prediction] : h.summary.slides[e].by_distance) {
      rows += slide_row(h, scale, e, distance, y);
      y += row_height;
    }
  }
  *bottom = y;
  return distance_axis(scale, top, y) + rows;
}

std::string heading(const Hindcast& h) {
  const auto& s = h.summary;
  std::string text = fmt::format("{}: {} past slides, {} members, {:.0f} effective", h.asked.name,
                                 s.slides.size(), s.members, s.posterior.effective);
  return text + (s.doubts.empty() ? "" : "; the weights are not to be trusted");
}

}  // namespace

std::string hindcast_svg(const Hindcast& hindcast) {
  std::string body = text_at(left, 22, "start", heading(hindcast), " font-size=\"14\"");
  body +=
      text_at(left, 40, "start",
              fmt::format("cumulated weight of each shared input before (grey) and after (red); "
                          "{}",
                          hindcast_condition),
              muted);
  const std::size_t panels = hindcast.summary.inputs.size();
  for (std::size_t i = 0; i < panels; ++i) {
    const std::size_t column = i % panels_a_row, row = i / panels_a_row;
    body += input_panel(hindcast, i, left + static_cast<double>(column) * (panel_width + between),
                        panels_top + static_cast<double>(row) * panel_step);
  }
  const std::size_t rows = (panels + panels_a_row - 1) / panels_a_row;
  const double top = panels_top + static_cast<double>(rows) * panel_step;
  body += text_at(left, top - 10, "start",
                  fmt::format("each slide from the others: {:.0f} % interval and median (red), "
                              "observed (cross, or line below for bounds)",
                              100 * hindcast.asked.plan.confidence),
                  muted);
  double bottom = top;
  body += slides_panel(hindcast, top, &bottom);
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" "
             "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" "
             "fill=\"#fff\"/>\n",
             whole_width, bottom + 60) +
         body + "</svg>\n";
}

}  // namespace leda::server
