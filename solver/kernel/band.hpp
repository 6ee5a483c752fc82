#pragma once
// Softening over a band of its own thickness. The plastic strain that a point takes in a step
// enters its softening as the average over the band around it (a nonlocal strain: Pijaudier-Cabot
// and Bazant 1987), so that the slip across a band, and the work it takes, do not depend on the
// cell.
//
//   e_i = sum w m gamma_step / sum w m,   smoothed by `passes` of (share, 1 - 2 share, share)
//   gamma += sum w e_i                    of points that have yielded themselves
//
// on the nodes i, with splines w and masses m. A slip U in one row of cells then raises gamma at
// its middle by U / band: `passes` and `share` follow from that (make_grid). Points that have not
// yielded keep their peak strength, however near a band is.

#include "solver/kernel/model.hpp"

namespace leda::solver {

/// The average of the last step's plastic strain on the nodes, where ground has yielded or is
/// within reach of such. To be called between the balance of the nodes and the points.
template <class Real>
void average_band(Model<Real>& model, ThreadTeam& team);

}  // namespace leda::solver
