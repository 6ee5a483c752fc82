#pragma once
// The passes of one step, for each number type: functions of vector code, chosen by the processor
// (Highway). How they make a step: solver/kernel/model.cpp.

#include <string>

#include "solver/kernel/grid.hpp"
#include "solver/kernel/packs.hpp"
#include "solver/materials/laws.hpp"

namespace leda::solver {

struct StepSettings {
  double dt = 0;       ///< s
  double gravity = 0;  ///< m/s2, downwards
  double damping = 0;  ///< local damping: this share of the unbalanced force, against motion
  bool move = true;    ///< false: positions and volumes are held (initial stress)
};

/// Energies in J and forces in N, per metre of width.
struct GridSums {
  double kinetic_before = 0;  ///< of the nodes, before the forces act
  double kinetic_after = 0;
  double damping_work = 0;  ///< done by damping, <= 0
  /// Sums of |internal + gravity| and |gravity| over the nodes; zero where the grid keeps no force.
  double unbalanced_force = 0, weight = 0;
};

/// What one pass over the points adds up.
struct PointSums {
  double stress_work = 0;  ///< J per metre: stress power of the step, mid-step stress
  double momentum_x = 0, momentum_z = 0;  ///< kg m/s per metre
  double fastest_squared = 0;             ///< largest |v|^2, m2/s2
  std::size_t strayed = 0;                ///< points outside their home cell after the step
  bool left_grid = false;                 ///< a point has gone where there are no nodes
  bool yields = false;                    ///< a point has yielded in the step
};

/// Quadratic B-splines (Steffen et al. 2008) with APIC (Jiang et al. 2015). Internal force and
/// strain use the true gradients of the splines and are conjugate:
/// sum_i f_i . v_i = - sum_p V sigma : grad v. Where the grid averages, dilation and the mean of
/// the in-plane normal stresses enter as their means over each span (B-bar, Hughes 1980), which
/// leaves the pair conjugate: sum V p_s div v = sum V_s p_s (div v)_s = sum V p (div v)_s.
///
/// Every function takes a range of packs, or of columns, and writes only to those, to the nodes
/// that they see, and to their spans.
template <class Real>
struct Kernel {
  std::string instructions;  ///< Highway's name of the target: "avx3" (AVX-512), "avx2", "sse4"
  std::size_t lanes;         ///< of a vector

  /// Momentum balance on the nodes of columns `first` to `last` - 1 (a column of ghost nodes goes
  /// with the column it mirrors): gravity, local damping (Cundall 1987 as Anura3D has it,
  /// f_d = -damping |f| sign(v), each axis by itself), edges, new velocity. The sums of the grid
  /// are zero afterwards.
  /// @pre 1 <= first, last <= columns - 1
  GridSums (*update_columns)(Grid<Real>& grid, const StepSettings& step, std::size_t first,
                             std::size_t last);

  /// Adds the points of packs `first` to `last` - 1 to the sums of the grid; finds the strays.
  /// False where a point has left the grid. Where the grid averages, the mean stresses are those
  /// of its spans.
  /// @pre packs.motion holds their motion, or they have none
  bool (*spread)(Packs<Real>& packs, Grid<Real>& grid, std::size_t first, std::size_t last);

  /// From the nodes to the points and on to the nodes of the next step, in one pass over memory:
  /// velocity and its gradient, stress, plastic strain, volume and position, then as spread().
  /// `keep`: packs.motion is written. Where the grid averages, dilation is that of the spans,
  /// packs.motion is always written, and spread() is left to the caller: points change their spans
  /// first.
  PointSums (*step)(Packs<Real>& packs, Grid<Real>& grid, const Laws<Real>& laws,
                    const StepSettings& step, bool keep, std::size_t first, std::size_t last);

  /// Adds volume, and volume times the dilation of a second, to the spans of the packs' columns.
  /// @pre no point has strayed; the spans are zero
  void (*add_dilation)(const Packs<Real>& packs, Grid<Real>& grid, std::size_t first,
                       std::size_t last);

  /// Largest slope that the velocities of the nodes have at the points, 1/s.
  double (*steepest)(const Packs<Real>& packs, Grid<Real>& grid, std::size_t first,
                     std::size_t last);

  /// The sums of the plastic strain of a step on the nodes of the band, edges folded; averages
  /// already where the band takes no smoothing. The sums given are zero afterwards.
  void (*add_up_band)(Grid<Real>& grid, std::size_t first, std::size_t last);

  /// One pass of smoothing; after the last the band holds averages.
  /// @pre the pass before has been done for all columns
  void (*smooth_band)(Grid<Real>& grid, std::size_t pass, std::size_t first, std::size_t last);

  /// Adds volume, and volume times the mean of the in-plane normal stresses, likewise.
  void (*add_stress)(const Packs<Real>& packs, Grid<Real>& grid, std::size_t first,
                     std::size_t last);
};

/// The kernel of this processor.
template <class Real>
const Kernel<Real>& kernel();

}  // namespace leda::solver
