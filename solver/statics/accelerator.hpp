#pragma once
// Anderson's acceleration of a modified Newton iteration.

#include <Eigen/Core>
#include <vector>

namespace leda::solver {

/// Anderson 1965, as Walker and Ni 2011 write it (type II, no damping of the mix): the next
/// iterate is the combination of the last ones whose correction K^-1 r is smallest, here in the
/// energy norm x . K x, which needs no product with K since K dx = dr is at hand.
class Accelerator {
 public:
  using Vector = Eigen::VectorXd;

  /// @param remembered most differences kept
  Accelerator(Eigen::Index unknowns, int remembered);

  /// @param x iterate  @param correction K^-1 r(x)  @param residual r(x)
  /// @return the next iterate
  Vector next(const Vector& x, const Vector& correction, const Vector& residual);

 private:
  Vector along_residuals(const Vector& v) const;
  void remember(const Vector& x, const Vector& correction, const Vector& residual);

  Eigen::Index most_, kept_ = 0, oldest_ = 0;
  bool started_ = false;
  // Kept in single precision: they only steer, the residual of where they lead to is taken anew.
  Eigen::MatrixXf moves_;        // differences of x + correction
  Eigen::MatrixXf corrections_;  // differences of K^-1 r
  Eigen::MatrixXf residuals_;    // differences of r
  Eigen::MatrixXd gram_;         // residuals_^T corrections_
  Vector x_, correction_, residual_;
};

}  // namespace leda::solver
