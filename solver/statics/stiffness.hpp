#pragma once
// Elastic stiffness of the ground as the transfers of the solver see it, positions held.

#include "solver/kernel/model.hpp"
#include "solver/statics/column_matrix.hpp"
#include "solver/statics/freedoms.hpp"

namespace leda::solver {

/// K = sum_p V_p B_p^T D_p B_p, N/m per metre of width, with the slopes of the quadratic
/// B-splines in B: with positions held the material point method is a finite element method
/// integrated at the particles (Steffen, Kirby and Berzins 2008). It is the derivative of
/// - force to displacement but for the rotation of the stress (Jaumann), a share stress / G.
/// Where the grid averages dilation over its spans, so does B.
/// @param filling this share of a full cell's stiffness is added to every span that holds a
///   particle, so that nodes which few particles hold have a stiffness too. K only guides the
///   iteration, the balance it finds does not depend on this.
/// @param laws whose moduli count  @pre no point has strayed
ColumnMatrix elastic_stiffness(const Model<double>& model, const LawTable& laws,
                               const Freedoms& freedoms, double filling);

}  // namespace leda::solver
