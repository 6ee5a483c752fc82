#pragma once
// Stresses in balance with the weight, found without steps in time.

#include <functional>
#include <optional>

#include "solver/kernel/grid_update.hpp"
#include "solver/kernel/particles.hpp"
#include "solver/materials/law_table.hpp"
#include "solver/statics/column_matrix.hpp"
#include "solver/statics/freedoms.hpp"

namespace leda::solver {

/// Where the iteration ended.
struct StaticBalance {
  enum class End { balanced, given_up, interrupted };
  End end = End::given_up;
  double ratio = 1;  ///< unbalanced force over weight, as update_velocity measures both
  int rounds = 0;    ///< stress updates of all particles
};

/// Solves r(u) = 0 for the displacement u of the nodes, r being the unbalanced force after one
/// stress update by u: modified Newton u += K^-1 r with the elastic K, factorized once, and
/// Anderson's acceleration. For the associated, perfectly plastic Tresca law r is the gradient of
/// a convex potential (but for the rotation of the stress), so the iteration finds the balance
/// where there is one. Positions are held.
class Statics {
 public:
  /// @return nothing where the factor would take more than 1 GB, a particle lies outside the
  ///   grid, or the stiffness is not positive definite
  static std::optional<Statics> prepare(Particles& particles, Grid& grid, const LawTable& laws);

  /// Balanced: stress and plastic strain are the new ones. Otherwise the particles are as they
  /// were. Velocities are overwritten in either case.
  /// @param laws without softening and rate  @param interrupted asked once a round, may be empty
  StaticBalance balance(Particles& particles, Grid& grid, const LawTable& laws,
                        const std::function<bool()>& interrupted) const;

 private:
  Statics(Freedoms freedoms, ColumnMatrix factor)
      : freedoms_(std::move(freedoms)), factor_(std::move(factor)) {}

  Freedoms freedoms_;
  ColumnMatrix factor_;
};

}  // namespace leda::solver
