#include "solver/screening/ground_path.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace leda::solver {
namespace {

constexpr std::size_t samples = 240;
/// Ground without relief nearby still gets this share of the points of steep ground.
constexpr double least_weight = 0.02;
/// Half the width of "nearby", in heights of the whole relief.
constexpr double window_heights = 1.5;
constexpr double least_turn_rad = 0.05;

double relief_of(const std::vector<Point>& points) {
  const auto [low, high] = std::ranges::minmax(points, {}, &Point::z);
  return high.z - low.z;
}

/// Relief within the window around every point, points in order of x.
std::vector<double> relief_nearby(const std::vector<Point>& points, double window) {
  std::vector<double> relief(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    double low = points[i].z;
    double high = points[i].z;
    for (const Point& p : points) {
      if (std::abs(p.x - points[i].x) > window) continue;
      low = std::min(low, p.z);
      high = std::max(high, p.z);
    }
    relief[i] = high - low;
  }
  return relief;
}

}  // namespace

GroundPath::GroundPath(const Polyline& ground) : ground_(ground), distances_(ground.size(), 0) {
  for (std::size_t i = 1; i < ground.size(); ++i) {
    distances_[i] = distances_[i - 1] +
                    std::hypot(ground[i].x - ground[i - 1].x, ground[i].z - ground[i - 1].z);
  }
}

Point GroundPath::at(double distance) const {
  const auto next = std::ranges::lower_bound(distances_, distance);
  if (next == distances_.begin()) return ground_.front();
  if (next == distances_.end()) return ground_.back();
  const auto i = static_cast<std::size_t>(next - distances_.begin());
  const double share = (distance - distances_[i - 1]) / (distances_[i] - distances_[i - 1]);
  const Point& a = ground_[i - 1];
  const Point& b = ground_[i];
  return {a.x + share * (b.x - a.x), a.z + share * (b.z - a.z)};
}

std::vector<double> GroundPath::corners(std::size_t most) const {
  std::vector<std::pair<double, double>> turns;  // sharpness, distance
  for (std::size_t i = 1; i + 1 < ground_.size(); ++i) {
    const Point& a = ground_[i - 1];
    const Point& b = ground_[i];
    const Point& c = ground_[i + 1];
    const double turn =
        std::abs(std::atan2(b.z - a.z, b.x - a.x) - std::atan2(c.z - b.z, c.x - b.x));
    // A sharp corner between short pieces is roughness of the terrain, not of the bank.
    const double reach =
        std::min(distances_[i] - distances_[i - 1], distances_[i + 1] - distances_[i]);
    if (turn > least_turn_rad) turns.emplace_back(turn * reach, distances_[i]);
  }
  std::ranges::sort(turns, std::greater{});
  if (turns.size() > most) turns.resize(most);
  std::vector<double> at;
  at.reserve(turns.size());
  for (const auto& [sharpness, distance] : turns) at.push_back(distance);
  return at;
}

std::vector<double> GroundPath::stations(std::size_t count) const {
  std::vector<Point> points(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    points[i] = at(length() * static_cast<double>(i) / (samples - 1));
  }
  const double relief = relief_of(points);
  if (relief <= 0) return {};
  std::vector<double> sum = relief_nearby(points, window_heights * relief);
  double total = 0;
  for (double& w : sum) w = total += w / relief + least_weight;
  std::vector<double> at = corners(10);
  for (std::size_t i = 0; i < count; ++i) {
    const double wanted = total * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    const auto sample = std::ranges::lower_bound(sum, wanted) - sum.begin();
    at.push_back(length() * static_cast<double>(sample) / (samples - 1));
  }
  std::ranges::sort(at);
  const auto close = [&](double a, double b) { return b - a < 0.01 * relief; };
  at.erase(std::unique(at.begin(), at.end(), close), at.end());
  return at;
}

}  // namespace leda::solver
