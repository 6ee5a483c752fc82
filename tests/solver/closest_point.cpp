#include "tests/solver/closest_point.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <vector>

namespace leda::solver::test {

namespace {

struct Constraint {
  Eigen::Vector3d normal, flow;
  double most;
};

// The closest point is in the order of the trial stress, so differences the other way round never
// reach 2 s.
std::vector<Constraint> constraints_of(const YieldBody& body, const Eigen::Vector3d& trial) {
  std::vector<Constraint> all;
  for (int i = 0; i < 3; ++i) {
    all.push_back({Eigen::Vector3d::Unit(i), Eigen::Vector3d::Unit(i), body.tension});
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (i == j || trial(i) < trial(j) || (trial(i) == trial(j) && i > j)) continue;
      const Eigen::Vector3d high = Eigen::Vector3d::Unit(i), low = Eigen::Vector3d::Unit(j);
      const double sin = body.sin_friction;
      all.push_back({(1 + sin) * high - (1 - sin) * low, high - low,
                     2 * (body.shear - body.pore_pressure * sin)});
    }
  }
  return all;
}

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;

}  // namespace

std::array<double, 3> closest_point(const std::array<double, 3>& trial, const YieldBody& body,
                                    double g, double lame) {
  const Eigen::Vector3d from(trial[0], trial[1], trial[2]);
  const std::vector<Constraint> all = constraints_of(body, from);
  const Eigen::Matrix3d stiffness =
      2 * g * Eigen::Matrix3d::Identity() + Eigen::Matrix3d::Constant(lame);
  const auto beyond_by = [&](const Eigen::Vector3d& at) {
    double most = 0;
    for (const Constraint& c : all) most = std::max(most, c.normal.dot(at) - c.most);
    return most;
  };
  // Of sets that differ by rounding alone the one that violates least.
  std::array<double, 3> closest = trial;
  double least = beyond_by(from);
  for (unsigned set = 1; set < 1U << all.size(); ++set) {
    std::vector<std::size_t> active;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if ((set >> i & 1U) != 0) active.push_back(i);
    }
    if (active.size() > 3) continue;
    const auto n = static_cast<Eigen::Index>(active.size());
    Matrix normals(3, n), flows(3, n);
    Vector beyond(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Constraint& c = all[active[static_cast<std::size_t>(i)]];
      normals.col(i) = c.normal;
      flows.col(i) = c.flow;
      beyond(i) = c.normal.dot(from) - c.most;
    }
    const Matrix system = normals.transpose() * stiffness * flows;
    const Eigen::FullPivLU<Matrix> solver(system);
    if (!solver.isInvertible()) continue;
    const Vector multiplier = solver.solve(beyond);
    if (multiplier.minCoeff() < 0) continue;
    const Eigen::Vector3d at = from - stiffness * (flows * multiplier);
    if (beyond_by(at) >= least) continue;
    least = beyond_by(at);
    closest = {at(0), at(1), at(2)};
  }
  return closest;
}

}  // namespace leda::solver::test
