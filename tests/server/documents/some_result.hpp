#pragma once

#include "solver/section/section_result.hpp"

namespace leda::test {

inline SectionResult some_result() {
  SectionResult r;
  r.status = RunStatus::at_rest;
  r.crest_to_crest_retrogression_m = 103.2;
  r.runout_m = 52.4;
  r.runout_from_crest_m = 89.4;
  r.crest = {183, 21.7};
  r.toe = {220, 5};
  r.backscarp = {79.8, 21.7};
  r.front = {272.4, 17};
  r.trigger_used = "undrained";
  r.slides = 6;
  r.simulated_s = 61;
  r.run_time_s = 40.2;
  r.steps = 24000;
  r.particles = 41000;
  r.ns_per_particle_step = 40.85;
  r.balances = {0, 1e-12, 0.004};
  r.numerical_dissipation = 0.07;
  r.profile_after = {{0, 21.7},   {79.8, 21.7}, {80.2, 15.1}, {120, 14.2}, {126, 17.3},
                     {135, 13.1}, {190, 11.9},  {220, 10.2},  {250, 17.2}, {306, 17}};
  r.warnings = {"front within two cells of the edge"};
  r.case_sha256 = std::string(64, 'a');
  r.version = "0.1.0";
  r.engine = {Precision::single_precision, "avx2", 0.65, false};
  return r;
}

}  // namespace leda::test
