#include "server/drawings/study_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "server/drawings/svg.hpp"

namespace leda::server {
namespace {

using solver::Measure;
using solver::SettingSummary;

constexpr double panel_width = 400, panel_height = 380;
constexpr double left = 74, top = 78, between = 74, legend_width = 220, below = 62;
constexpr double mark_size = 6, smallest_mark = 4.5, largest_mark = 9;

/// From dark for the finest cell to light for the coarsest: anchors of viridis, told apart by
/// colour-blind readers and in grey.
std::string colour_of(double share) {
  constexpr std::array<std::array<double, 3>, 5> anchors{
      {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {222, 190, 20}}};
  const double at = std::clamp(share, 0.0, 1.0) * (anchors.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), anchors.size() - 2);
  const double t = at - static_cast<double>(low);
  std::array<int, 3> rgb{};
  for (std::size_t i = 0; i < 3; ++i) {
    rgb[i] = int(std::lround((1 - t) * anchors[low][i] + t * anchors[low + 1][i]));
  }
  return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

/// Shapes of the numbers of particles; all of about one area at one size.
std::string mark(double x, double y, int particles, double s, const std::string& fill,
                 const std::string& stroke) {
  const std::string style =
      fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"1.8\"", fill, stroke);
  const auto path = [&](const std::string& d) {
    return fmt::format("<path d=\"M{:.1f} {:.1f}{}Z\" {}/>\n", x, y, d, style);
  };
  switch (particles) {
    case 1:
      return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" {}/>\n", x, y, s - 0.5,
                         style);
    case 4:
      return path(fmt::format("m{0} {0}h{1}v{1}h{2}", -0.85 * s, 1.7 * s, -1.7 * s));
    case 9:
      return path(fmt::format("m0 {}l{} {}h{}", -1.2 * s, 1.1 * s, 2 * s, -2.2 * s));
    case 16:
      return path(fmt::format("m0 {0}l{1} {1}l{0} {1}l{0} {0}", -1.3 * s, 1.3 * s));
    default:
      return path(fmt::format("m0 {}l{} {}h{}", 1.2 * s, 1.1 * s, -2 * s, -2.2 * s));
  }
}

/// A logarithmic axis; values below it stand on its lower end.
struct Axis {
  double least = 1, most = 10;
  double share(double value) const {
    return std::log(std::max(value, least) / least) / std::log(most / least);
  }
  std::vector<double> ticks() const {
    const bool long_range = most / least > 300;
    std::vector<double> values;
    const int first = static_cast<int>(std::floor(std::log10(least)));
    const int last = static_cast<int>(std::floor(std::log10(most)));
    for (int decade = first; decade <= last; ++decade) {
      for (const double factor : {1.0, 2.0, 5.0}) {
        const double value = factor * std::pow(10, decade);
        if (long_range && factor > 1) continue;
        if (value >= 0.999 * least && value <= 1.001 * most) values.push_back(value);
      }
    }
    return values;
  }
};

/// Around the values above 0, with room at both ends.
Axis axis_around(const std::vector<double>& values, double lowest) {
  Axis axis{INFINITY, 0};
  for (const double v : values) {
    if (v <= 0) continue;
    axis.least = std::min(axis.least, v);
    axis.most = std::max(axis.most, v);
  }
  if (axis.most == 0) return {lowest, 10 * lowest};
  axis.least = std::max(axis.least / 1.5, lowest);
  axis.most = std::max(axis.most * 1.5, 5 * axis.least);
  return axis;
}

struct Panel {
  Measure measure = Measure::retrogression;
  double x0 = left;
  Axis time, percent;
  double x(double seconds) const { return x0 + panel_width * time.share(seconds); }
  double y(double value) const { return top + panel_height * (1 - percent.share(value)); }
};

std::string axes(const Panel& panel) {
  const double bottom = top + panel_height, right = panel.x0 + panel_width;
  std::string out = fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.0f}\" height=\"{:.0f}\" fill=\"#ffffff\" "
      "stroke=\"#888888\"/>\n",
      panel.x0, top, panel_width, panel_height);
  const std::string grid = "stroke=\"#e2e2e2\"";
  for (const double t : panel.time.ticks()) {
    out += line(panel.x(t), top, panel.x(t), bottom, grid);
    out += text_at(panel.x(t), bottom + 17, "middle", fmt::format("{:g}", t));
  }
  for (const double p : panel.percent.ticks()) {
    out += line(panel.x0, panel.y(p), right, panel.y(p), grid);
    out += text_at(panel.x0 - 7, panel.y(p) + 4, "end", fmt::format("{:g}", p));
  }
  out += text_at(panel.x0 + panel_width / 2, bottom + 38, "middle",
                 "run time of one run (s, undisturbed)");
  out += fmt::format(
      "<text transform=\"translate({:.1f},{:.1f}) rotate(-90)\" text-anchor=\"middle\">error of "
      "{} (%)</text>\n",
      panel.x0 - 46, top + panel_height / 2, solver::to_string(panel.measure));
  return out;
}

std::string level(const Panel& panel, double percent, const std::string& name, const char* dash) {
  if (percent <= panel.percent.least || percent >= panel.percent.most) return "";
  const double y = panel.y(percent);
  return line(panel.x0, y, panel.x0 + panel_width, y,
              fmt::format("stroke=\"#b00020\" stroke-dasharray=\"{}\"", dash)) +
         text_at(panel.x0 + panel_width - 6, y - 4, "end", name,
                 " fill=\"#b00020\" font-size=\"11\"");
}

/// Share of the way from the first to the last of the values.
template <class Value>
double rank(const std::set<Value>& values, Value value) {
  if (values.size() < 2) return 0;
  const auto at = std::distance(values.begin(), values.find(value));
  return double(at) / double(values.size() - 1);
}

/// What tells settings apart.
struct Look {
  std::set<double> cells;
  std::set<int> particles;
  std::set<double> steps;  ///< none where names do not tell them
  std::string colour(double cell_m) const { return colour_of(rank(cells, cell_m)); }
  double size(double step) const {
    if (steps.size() < 2) return mark_size;
    return smallest_mark + rank(steps, step) * (largest_mark - smallest_mark);
  }
};

Look look_of(const Study& study) {
  const bool with_steps = tells_time_step(study.asked);
  Look look;
  for (const SettingSummary& s : study.summary.settings) {
    look.cells.insert(s.setting.cell_m);
    look.particles.insert(s.setting.particles_per_cell);
    if (with_steps) look.steps.insert(s.setting.time_step_factor);
  }
  return look;
}

/// Whiskers and mark of one setting; nothing where it has no usable run.
std::string setting_mark(const Panel& panel, const SettingSummary& s, const Look& look) {
  const auto& error = s.by(panel.measure).error;
  if (!error) return "";
  const std::string colour = look.colour(s.setting.cell_m);
  const double x = panel.x(*s.cost_s), y = panel.y(100 * error->mean);
  const std::string thin = fmt::format("stroke=\"{}\" stroke-width=\"1.2\"", colour);
  std::string out = line(x, panel.y(100 * error->least), x, panel.y(100 * error->most), thin) +
                    line(panel.x(s.run_time_s->least), y, panel.x(s.run_time_s->most), y, thin);
  return out + mark(x, y, s.setting.particles_per_cell, look.size(s.setting.time_step_factor),
                    s.not_a_choice.empty() ? colour : "#ffffff", colour);
}

std::string ring(const Panel& panel, const Study& study) {
  const auto index = study.summary.fastest_by(panel.measure).by_mean;
  if (!index) return "";
  const SettingSummary& s = study.summary.settings[*index];
  return fmt::format(
      "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"13\" fill=\"none\" stroke=\"#222222\" "
      "stroke-width=\"1.6\"/>\n",
      panel.x(*s.cost_s), panel.y(100 * s.by(panel.measure).error->mean));
}

/// Cell sizes, numbers of particles, and time steps where there are some.
std::string legend_of_axes(const Look& look, double x, double& y) {
  constexpr const char* bold = " font-weight=\"bold\"";
  std::string out = text_at(x, y, "start", "cell size", bold);
  for (const double cell : look.cells) {
    y += 20;
    out += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"18\" height=\"11\" fill=\"{}\"/>\n",
                       x, y - 10, look.colour(cell));
    out += text_at(x + 26, y, "start", fmt::format("{:g} m", cell));
  }
  y += 34;
  out += text_at(x, y, "start", "particles per cell", bold);
  for (const int count : look.particles) {
    y += 21;
    out += mark(x + 9, y - 4, count, mark_size, "#777777", "#777777");
    out += text_at(x + 26, y, "start", fmt::format("{}", count));
  }
  if (look.steps.empty()) return out;
  y += 34;
  out += text_at(x, y, "start", "time step factor", bold);
  for (const double step : look.steps) {
    y += 21;
    out += mark(x + 9, y - 4, 4, look.size(step), "#777777", "#777777");
    out += text_at(x + 26, y, "start", fmt::format("{:g}", step));
  }
  return out;
}

std::string legend(const Look& look, double x) {
  double y = top + 12;
  std::string out = legend_of_axes(look, x, y);
  y += 34;
  out += mark(x + 9, y - 4, 4, mark_size, "#ffffff", "#777777");
  out += text_at(x + 26, y, "start", "no choice: at the edge, not at");
  out += text_at(x + 26, y + 14, "start", "rest, unstable, the reference");
  y += 42;
  out += fmt::format(
      "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"9\" fill=\"none\" stroke=\"#222222\" "
      "stroke-width=\"1.6\"/>\n",
      x + 9, y - 4);
  out += text_at(x + 26, y, "start", "fastest within the");
  out += text_at(x + 26, y + 14, "start", "wanted error (mean)");
  y += 42;
  out += text_at(x, y, "start", "whiskers: least to largest");
  return out + text_at(x, y + 14, "start", "over seeds");
}

Panel panel_of(const Study& study, Measure measure, double x0) {
  std::vector<double> times, percents{100 * study.asked.question.wanted_error};
  for (const SettingSummary& s : study.summary.settings) {
    const auto& error = s.by(measure).error;
    if (!error) continue;
    times.insert(times.end(), {s.run_time_s->least, *s.cost_s, s.run_time_s->most});
    for (const double e : {error->least, error->mean, error->most}) percents.push_back(100 * e);
  }
  return {measure, x0, axis_around(times, 1e-3), axis_around(percents, 0.05)};
}

std::string draw(const Panel& panel, const Study& study, const Look& look) {
  std::string out = axes(panel);
  out += level(panel, 100 * study.asked.question.wanted_error, "wanted error", "7 4");
  const auto& scatter = panel.measure == Measure::retrogression
                            ? study.summary.scatter_retrogression
                            : study.summary.scatter_runout;
  if (scatter) out += level(panel, 100 * *scatter, "scatter between settings", "2 4");
  for (const SettingSummary& s : study.summary.settings) {
    out += setting_mark(panel, s, look);
  }
  return out + ring(panel, study);
}

std::string reference_line(const Study& study) {
  const auto& reference = study.summary.reference;
  if (!reference) return "nothing to compare: no setting has come to rest in all its runs";
  std::string text = "against";
  if (reference->retrogression_m) {
    text += fmt::format(" retrogression {:.4g} m,", *reference->retrogression_m);
  }
  if (reference->runout_m) text += fmt::format(" runout {:.4g} m,", *reference->runout_m);
  text += " " + reference->source;
  if (const auto index = study.summary.reference_index) {
    text += " (" + setting_name(study, study.summary.settings[*index].setting) + ")";
  }
  return text;
}

}  // namespace

std::string study_svg(const Study& study) {
  const Look look = look_of(study);
  std::vector<Panel> panels;
  const auto add = [&](Measure measure, bool compared) {
    if (!compared) return;
    const double x0 = left + double(panels.size()) * (panel_width + between);
    panels.push_back(panel_of(study, measure, x0));
  };
  const auto& reference = study.summary.reference;
  add(Measure::retrogression, reference && reference->retrogression_m);
  add(Measure::runout, reference && reference->runout_m);
  const double legend_x = left + double(std::max<std::size_t>(panels.size(), 1)) * panel_width +
                          (panels.size() > 1 ? between : 0) + 28;
  std::string body;
  for (const Panel& panel : panels) body += draw(panel, study, look);
  // Numbers of values are bounded, so the legend is.
  const double of_steps = look.steps.empty() ? 0 : 34 + 21.0 * double(look.steps.size());
  const double rows =
      20.0 * double(look.cells.size()) + 21.0 * double(look.particles.size()) + of_steps;
  const double height = std::max(top + panel_height + below, top + rows + 250);
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
             "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\" font-size=\"12\" "
             "fill=\"#222222\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fafafa\"/>\n",
             legend_x + legend_width, height) +
         text_at(left, 30, "start", study.asked.name + ": error over run time",
                 " font-size=\"17\" font-weight=\"bold\"") +
         text_at(left, 52, "start", reference_line(study)) + body + legend(look, legend_x) +
         "</svg>\n";
}

}  // namespace leda::server
