#include "server/drawings/ensemble_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "server/drawings/svg.hpp"

namespace leda::server {
namespace {

using solver::Distance;
using solver::DistanceSummary;
using solver::ExceedanceCurve;

constexpr double panel_width = 430, panel_height = 300;
constexpr double left = 66, top = 96, between = 80, margin = 24;
constexpr double bars_top = top + panel_height + 76, bar_height = 18;
constexpr std::array colours{"#b2182b", "#2166ac", "#1b7837", "#762a83"};
constexpr const char* muted = " fill=\"#555\"";

struct Panel {
  double x0 = 0;
  double most_m = 1;
  double x(double metres) const { return x0 + panel_width * std::clamp(metres / most_m, 0.0, 1.0); }
  double y(double probability) const { return top + panel_height * (1 - probability); }
};

const DistanceSummary& of(const SectionEnsemble& section, Distance distance) {
  return section.summary.by_distance.at(distance);
}

Panel panel_of(const std::vector<SectionEnsemble>& sections, Distance distance, double x0) {
  Panel panel{x0};
  for (const auto& section : sections) {
    panel.most_m =
        std::max(panel.most_m, 1.05 * of(section, distance).curve.points.back().distance_m);
  }
  return panel;
}

std::string axes(const Panel& panel, Distance distance) {
  std::string out = fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.0f}\" height=\"{:.0f}\" fill=\"none\" "
      "stroke=\"#444\"/>\n",
      panel.x0, top, panel_width, panel_height);
  const double step = tick_step(panel.most_m);
  for (int i = 0; i * step <= panel.most_m; ++i) {
    const double x = panel.x(i * step);
    out += line(x, top, x, top + panel_height, "stroke=\"#ddd\"");
    out += text_at(x, top + panel_height + 17, "middle", fmt::format("{:g}", i * step));
  }
  for (int i = 0; i <= 5; ++i) {
    const double y = panel.y(0.2 * i);
    out += line(panel.x0, y, panel.x0 + panel_width, y, "stroke=\"#ddd\"");
    out += text_at(panel.x0 - 7, y + 4, "end", fmt::format("{} %", 20 * i));
  }
  const std::string name =
      distance == Distance::retrogression ? "retrogression" : "runout from the toe";
  return out + text_at(panel.x0 + panel_width / 2, top + panel_height + 36, "middle",
                       name + " is more than this, m");
}

/// A step line: flat from each point to the next, the last one to the panel's edge.
template <class Value>
std::string steps(const Panel& panel, const ExceedanceCurve& curve, const Value& value) {
  std::string d;
  for (const auto& point : curve.points) {
    const double x = panel.x(point.distance_m), y = panel.y(value(point));
    d += d.empty() ? fmt::format("M{:.1f} {:.1f}", x, y) : fmt::format("H{:.1f}V{:.1f}", x, y);
  }
  return d + fmt::format("H{:.1f}", panel.x0 + panel_width);
}

/// Between the two ends of the intervals: forth along the upper one, back along the lower one.
std::string band(const Panel& panel, const ExceedanceCurve& curve) {
  std::string d = steps(panel, curve, [](const auto& p) { return p.interval.high; });
  d += fmt::format("V{:.1f}", panel.y(curve.points.back().interval.low));
  for (std::size_t i = curve.points.size(); i-- > 0;) {
    d += fmt::format("H{:.1f}", panel.x(curve.points[i].distance_m));
    if (i > 0) d += fmt::format("V{:.1f}", panel.y(curve.points[i - 1].interval.low));
  }
  return d + "Z";
}

std::string marks(const Panel& panel, const DistanceSummary& summary, const char* colour) {
  std::string out;
  for (const auto& q : summary.quantiles) {
    const double y = panel.y(q.exceedance);
    const double high = q.by_ranks.high_m.value_or(panel.most_m);
    out += line(panel.x(q.by_ranks.low_m), y, panel.x(high), y,
                fmt::format("stroke=\"{}\" stroke-width=\"1.6\"", colour));
    if (!q.distance_m) continue;
    out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.6\" fill=\"{}\"/>\n",
                       panel.x(*q.distance_m), y, colour);
    const bool at_edge = *q.distance_m > 0.85 * panel.most_m;
    out += text_at(panel.x(*q.distance_m) + (at_edge ? -6 : 6), y - 5, at_edge ? "end" : "start",
                   distance_text(q));
  }
  return out;
}

std::string curve(const Panel& panel, const DistanceSummary& summary, const char* colour) {
  const auto estimate = [](const auto& p) { return p.probability; };
  return fmt::format("<path d=\"{}\" fill=\"{}\" fill-opacity=\"0.18\"/>\n",
                     band(panel, summary.curve), colour) +
         fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.8\"/>\n",
                     steps(panel, summary.curve, estimate), colour) +
         marks(panel, summary, colour);
}

std::string heading(const SectionEnsemble& section) {
  const auto& s = section.summary;
  return fmt::format("{}: {} members, slides with {:.0f} % ({:.0f} to {:.0f} %), curves to {:.3f}",
                     section.section, s.members, 100 * s.probability_of_sliding,
                     100 * s.sliding.low, 100 * s.sliding.high, s.half_width);
}

/// Which input decides how much of the variance, and chance where it was looked at.
std::string bars(const Panel& panel, const SectionEnsemble& section, Distance distance) {
  const auto& summary = of(section, distance);
  const auto& inputs = section.asked.plan.inputs;
  std::string out =
      text_at(panel.x0, bars_top - 8, "start", "decided by (share of the variance)", muted);
  double y = bars_top;
  const auto bar = [&](const std::string& name, double share, double error) {
    const double width = 0.6 * panel_width;
    const auto x = [&](double s) {
      return panel.x0 + 0.3 * panel_width + width * std::clamp(s, 0.0, 1.0);
    };
    out += text_at(panel.x0 + 0.3 * panel_width - 6, y + 12, "end", name);
    out += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"11\" fill=\"#8da0b5\"/>\n", x(0),
        y + 2, x(share) - x(0));
    out += line(x(share - error), y + 7.5, x(share + error), y + 7.5, "stroke=\"#222\"");
    out += text_at(x(share + error) + 6, y + 12, "start", fmt::format("{:.2f}", share));
    y += bar_height;
  };
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (const auto& index = summary.indices[i]) {
      bar(inputs[i].name, index->first_order, index->standard_error);
    }
  }
  if (summary.chance && summary.chance->share) bar("chance", *summary.chance->share, 0);
  return out;
}

}  // namespace

std::string ensemble_svg(const std::vector<SectionEnsemble>& sections) {
  const bool single = sections.size() == 1;
  const double rows = single ? double(sections.front().asked.plan.inputs.size()) + 1 : 0;
  const double width = left + 2 * panel_width + between + margin;
  const double height = single ? bars_top + rows * bar_height + margin : bars_top - 20;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" "
      "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" "
      "fill=\"#fff\"/>\n",
      width, height);
  double y = 24;
  for (std::size_t i = 0; i < sections.size(); ++i, y += 18) {
    const std::string style =
        fmt::format(" font-size=\"14\" fill=\"{}\"", colours[i % colours.size()]);
    svg += text_at(left, y, "start", heading(sections[i]), style.c_str());
  }
  svg += text_at(left, top - 12, "start", ensemble_condition, muted);
  for (const Distance distance : solver::distances) {
    const double x0 = distance == Distance::retrogression ? left : left + panel_width + between;
    const Panel panel = panel_of(sections, distance, x0);
    svg += axes(panel, distance);
    for (std::size_t i = 0; i < sections.size(); ++i) {
      svg += curve(panel, of(sections[i], distance), colours[i % colours.size()]);
    }
    if (single) svg += bars(panel, sections.front(), distance);
  }
  return svg + "</svg>\n";
}

}  // namespace leda::server
