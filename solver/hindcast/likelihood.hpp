#pragma once
// How well a member's distances agree with what was observed.

#include "solver/ensemble/outcome.hpp"
#include "solver/hindcast/observation.hpp"

namespace leda::solver {

/// ln of the density of what was observed (of a bounded distance: of its probability), given the
/// distances of a member that slid. A member that was cut short counts at the distance it may have
/// reached that is nearest to what was observed.
/// @param bias_ln b of the discrepancy
/// @pre the member slid, so that its distances are known or bounded from below
double log_likelihood(const PastSlide& slide, const Reach& retrogression, const Reach& runout,
                      const Discrepancy& discrepancy, double bias_ln);

/// ln of the distance that a member counts at.
double ln_counted(const Observed& observed, const Reach& reach, double least_m, double bias_ln);

}  // namespace leda::solver
