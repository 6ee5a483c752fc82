#pragma once
// The decision whether a section needs a simulation, with the numbers it rests on.

#include <optional>
#include <string>
#include <vector>

#include "solver/screening/analytics.hpp"
#include "solver/screening/limit_equilibrium.hpp"
#include "solver/screening/site.hpp"
#include "solver/section/run_settings.hpp"
#include "solver/section/section.hpp"

namespace leda::solver {

enum class Decision { simulate, stable };

const char* to_string(Decision decision);

/// How far the inputs of a section may be from the truth on the bad side, and how far from 1 a
/// factor must then still be. Where the values come from: solver/screening/README.md.
struct ScreeningMargins {
  double strength = 0.10;            ///< share by which peak strengths may be too high
  double unit_weight = 0.03;         ///< share by which unit weights may be too low
  double water_table_m = 1.0;        ///< by which the water may stand lower
  double factor = 0.8;               ///< what a factor for these worst inputs must be above 1
  double asked_cut_factor = 1.2;     ///< the same for a cut that the simulation will make: ground
                                     ///< that goes suddenly starts brittle clay far above 1
  double toe_cut_m = 3.0;            ///< the cut looked at where the case asks for none, ...
  double toe_cut_share = 1.0 / 3.0;  ///< ... but no more than this share of the bank
};

struct ScreeningResult {
  Decision decision = Decision::simulate;
  std::vector<std::string> reasons;     ///< the deciding one first
  bool sensitive = false;               ///< a softening material lies in the section
  double required_intact = 0;           ///< what worst_intact must reach
  double required_toe_cut = 0;          ///< what worst_toe_cut must reach
  double toe_cut_m = 0;                 ///< height of the cut looked at; 0: none
  std::optional<double> worst_intact;   ///< undrained Bishop for the worst inputs
  std::optional<double> worst_toe_cut;  ///< the same with the toe cut
  std::optional<double> worst_at_rest;  ///< factor_at_rest for the worst inputs
  FactorsOfSafety drained, undrained, undrained_toe_cut;
  Analytics analytics;
};

/// Screens one section: every number, in tens of milliseconds. Never throws on a valid section.
/// Factors are those of the weak ground where strength varies within it (weak_ground.hpp),
/// analytics those of the mean.
/// @pre validate(section, settings) is empty
ScreeningResult screen(const Section& section, const RunSettings& settings,
                       const ScreeningMargins& margins = {});

/// The decision and the analytics, as fast as they can be had: no drained factors, of the undrained
/// ones Bishop's only, and none that the decision does not need.
ScreeningResult screen_quickly(const Section& section, const RunSettings& settings,
                               const ScreeningMargins& margins = {});

/// Screens a site: its analytics, and factors and decision for the section that section_of makes
/// of it (none without a slope angle: then the decision is to simulate).
ScreeningResult screen_site(const Site& site, const ScreeningMargins& margins = {});

}  // namespace leda::solver
