#pragma once
// Stresses in balance with the weight, found without steps in time.

#include <functional>
#include <optional>

#include "solver/kernel/model.hpp"
#include "solver/statics/column_matrix.hpp"
#include "solver/statics/freedoms.hpp"

namespace leda::solver {

/// Where the iteration ended.
struct StaticBalance {
  enum class End { balanced, given_up, interrupted };
  End end = End::given_up;
  double ratio = 1;  ///< unbalanced force over weight
  int rounds = 0;    ///< stress updates of all particles
};

/// Solves r(u) = 0 for the displacement u of the nodes, r being the unbalanced force after one
/// stress update by u: modified Newton u += K^-1 r with the elastic K, factorized once, and
/// Anderson's acceleration. For the associated, perfectly plastic Tresca law r is the gradient of
/// a convex potential (but for the rotation of the stress), so the iteration finds the balance
/// where there is one. Positions are held.
class Statics {
 public:
  /// @return nothing where the factor would take more than 1 GB or the stiffness is not positive
  ///   definite
  /// @pre the grid of the model keeps forces; no point has strayed
  static std::optional<Statics> prepare(Model<double>& model, const LawTable& laws,
                                        ThreadTeam& team);

  /// Balanced: stress and plastic strain are the new ones. Otherwise the points are as they
  /// were. The sums of the grid have to be made anew in either case.
  /// @param interrupted asked once a round, may be empty
  /// @pre the model's laws have no softening and no rate; no point has plastic strain
  StaticBalance balance(Model<double>& model, ThreadTeam& team,
                        const std::function<bool()>& interrupted) const;

 private:
  Statics(Freedoms freedoms, ColumnMatrix factor)
      : freedoms_(std::move(freedoms)), factor_(std::move(factor)) {}

  Freedoms freedoms_;
  ColumnMatrix factor_;
};

}  // namespace leda::solver
