#pragma once
// One step of the material point method in plain double precision: no vectors, no packs, no order
// of sums to keep. What the kernel is held to.

#include <map>
#include <vector>

#include "solver/kernel/model.hpp"

namespace leda::solver::test {

/// Equations as in solver/README.md, each written down anew; nothing of the kernel is used.
class Oracle {
 public:
  Oracle(Particles particles, const GridSize& size, const LawTable& laws,
         const ModelSettings& settings);

  StepSums step(const StepSettings& settings);

  const Particles& particles() const { return particles_; }

 private:
  struct Node {
    double mass = 0, px = 0, pz = 0, fx = 0, fz = 0, vx = 0, vz = 0;
    double seen = 0;      ///< mass as if the ground went on beyond the edges
    double weight = 0;    ///< the same, smoothed
    double strained = 0;  ///< sum w m (plastic strain of the step); its average over the band
  };
  struct Span {
    double volume = 0, sum = 0;
  };

  Node& at(std::size_t i, std::size_t k) { return nodes_[i * size_.rows + k]; }
  template <class One>
  void for_nodes(const Particle& p, const One& one);
  std::pair<long, long> cell_of(const Particle& p) const;
  std::map<std::pair<long, long>, Span> span_means(const std::vector<double>& value) const;
  void to_nodes();
  void fold_edges();
  void mirror_edges();
  void average_band();
  void smooth(double Node::*value, double share);
  void move_nodes(const StepSettings& settings, GridSums& sums);
  void to_points(const StepSettings& settings, PointSums& sums);
  double strength(const Particle& p, double shear_rate, bool rated) const;
  double flow_strain(const Particle& p, double excess, double shear, double dt) const;
  double softer(const Particle& p, double seen) const;
  /// @return what cracks open, of the volume
  double stress(Particle& p, const double (&e)[3], double spin, double dt, double soft,
                PointSums& sums) const;

  Particles particles_;
  GridSize size_;
  LawTable laws_;
  ModelSettings settings_;
  std::vector<Node> nodes_;
};

}  // namespace leda::solver::test
