#include "solver/extremes/try_case.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "solver/extremes/finite.hpp"
#include "solver/run/simulate.hpp"
#include "solver/section/crest_and_toe.hpp"
#include "solver/section/fault_list.hpp"
#include "solver/section/validate.hpp"

namespace leda::solver {

namespace {

constexpr double most_mass_error = 1e-6;  // of single precision; the reference keeps 1e-12

// gamma H / s_u of the uppermost layer's clay.
double stability_number(const Section& section) {
  const Material& clay = section.materials.at(layers_of(section, 0).front().material);
  const auto bank = find_crest_and_toe(section.ground);
  const double height = bank ? bank->crest.z - bank->toe.z : 0;
  return clay.unit_weight * height / clay.peak_strength.largest();
}

Section with_strength(Section section, double factor) {
  for (auto& [name, material] : section.materials) {
    material.shear_modulus_Pa *= factor;
    material.peak_strength.constant_Pa *= factor;
    for (auto& row : material.peak_strength.table) row[1] *= factor;
  }
  return section;
}

void run(const Section& section, const ExtremeCase& extreme,
         const std::function<bool()>& interrupted, Outcome& outcome) {
  Listener listener;
  listener.interrupted = interrupted;
  listener.frame = [&](const Frame& f) { outcome.finite = outcome.finite && is_finite(f); };
  outcome.result = simulate(section, extreme.settings, listener);
  outcome.finite = outcome.finite && is_finite(outcome.result);
  outcome.ran = true;
}

// The worst of all runs of a bisection, and their steps together.
void add_up(const SectionResult& earlier, SectionResult& result) {
  result.steps += earlier.steps;
  Balances& b = result.balances;
  b.mass = std::max(b.mass, earlier.balances.mass);
  b.momentum = std::max(b.momentum, earlier.balances.momentum);
  b.energy = std::max(b.energy, earlier.balances.energy);
}

void bisect(const ExtremeCase& extreme, const std::function<bool()>& interrupted,
            Outcome& outcome) {
  const double number = stability_number(extreme.section);
  auto [stands, fails] = extreme.critical->bracket;
  while (fails - stands > extreme.critical->within) {
    const double middle = 0.5 * (stands + fails);
    const SectionResult earlier = outcome.result;
    run(with_strength(extreme.section, number / middle), extreme, interrupted, outcome);
    add_up(earlier, outcome.result);
    if (outcome.result.status == RunStatus::interrupted) return;
    (outcome.result.status == RunStatus::stable ? stands : fails) = middle;
  }
  outcome.critical_number = 0.5 * (stands + fails);
}

bool within(double value, const Band& band) { return value >= band[0] && value <= band[1]; }

std::string range(const Band& band) { return show(band[0]) + " to " + show(band[1]); }

void judge_status(const ExtremeCase& extreme, const Outcome& o, std::vector<std::string>& broken) {
  const RunStatus status = o.result.status;
  const auto& wanted = extreme.promise.statuses;
  if (std::ranges::find(wanted, status) == wanted.end()) {
    broken.push_back(std::string("ended ") + to_string(status) +
                     (o.result.reason.empty() ? "" : ": " + o.result.reason));
  }
  if (status == RunStatus::unstable && o.result.reason.empty()) {
    broken.emplace_back("gives no reason for being unstable");
  }
}

void judge_balances(const ExtremeCase& extreme, const Outcome& o,
                    std::vector<std::string>& broken) {
  if (!o.finite) broken.emplace_back("a value of a frame or of the result is not finite");
  const Balances& b = o.result.balances;
  if (!(b.mass < most_mass_error) || !(b.momentum < most_mass_error)) {
    broken.push_back("mass is off by " + show(b.mass) + ", momentum by " + show(b.momentum) +
                     ", at most " + show(most_mass_error));
  }
  if (!(b.energy <= extreme.promise.most_energy_error)) {
    broken.push_back("energy is off by " + show(b.energy) + ", at most " +
                     show(extreme.promise.most_energy_error));
  }
}

void judge_bands(const ExtremeCase& extreme, const Outcome& o, std::vector<std::string>& broken) {
  const Promise& p = extreme.promise;
  const double retrogression = o.result.crest_to_crest_retrogression_m;
  if (p.retrogression_m && !within(retrogression, *p.retrogression_m)) {
    broken.push_back("retrogression is " + show(retrogression) + " m, must be " +
                     range(*p.retrogression_m));
  }
  if (p.critical_number && o.critical_number && !within(*o.critical_number, *p.critical_number)) {
    broken.push_back("critical gamma H / s_u is " + show(*o.critical_number) + ", must be " +
                     range(*p.critical_number));
  }
}

void judge_likeness(const ExtremeCase& extreme, const Outcome& o,
                    const std::vector<Outcome>& before, std::vector<std::string>& broken) {
  const Promise& p = extreme.promise;
  if (p.like.empty()) return;
  const auto other = std::ranges::find(before, p.like, &Outcome::name);
  if (other == before.end()) {
    broken.push_back("has nothing to be compared with: " + p.like + " was not run");
    return;
  }
  const auto compare = [&](const char* what, double value, double wanted, double least) {
    const double most = std::max(p.like_within * std::abs(wanted), least);
    if (std::abs(value - wanted) <= most) return;
    broken.push_back(std::string(what) + " is " + show(value) + ", " + p.like + " has " +
                     show(wanted) + ": they must agree within " + show(most));
  };
  if (o.critical_number && other->critical_number) {
    compare("critical gamma H / s_u", *o.critical_number, *other->critical_number, 0);
    return;
  }
  const double cells = 2 * extreme.settings.resolution.cell_m;
  compare("retrogression", o.result.crest_to_crest_retrogression_m,
          other->result.crest_to_crest_retrogression_m, cells);
  compare("runout", o.result.runout_m, other->result.runout_m, cells);
}

// What validation says is part of the promise: refused where it must be, and nowhere else.
bool is_refused(const ExtremeCase& extreme, Outcome& outcome) {
  const auto faults = validate(extreme.section, extreme.settings);
  for (const Fault& f : faults) {
    outcome.refusal += (outcome.refusal.empty() ? "" : "; ") + f.pointer + " " + f.message;
  }
  if (extreme.unchecked) {
    if (faults.empty()) outcome.broken.emplace_back("is valid, but must be refused");
    return false;
  }
  const bool expected = !extreme.refused_at.empty();
  const bool found = std::ranges::find(faults, extreme.refused_at, &Fault::pointer) != faults.end();
  if (expected && !found) outcome.broken.push_back("is not refused at " + extreme.refused_at);
  if (!expected && !faults.empty()) outcome.broken.push_back("is refused: " + outcome.refusal);
  return expected || !faults.empty();
}

}  // namespace

Outcome try_case(const ExtremeCase& extreme, const std::vector<Outcome>& before,
                 const std::function<bool()>& interrupted) {
  using Clock = std::chrono::steady_clock;
  const auto began = Clock::now();
  Outcome outcome;
  outcome.name = extreme.name;
  outcome.extreme = extreme.extreme;
  if (is_refused(extreme, outcome)) return outcome;
  if (extreme.critical)
    bisect(extreme, interrupted, outcome);
  else
    run(extreme.section, extreme, interrupted, outcome);
  // A bisection ends on either side of failure: how is no promise.
  if (!extreme.critical || outcome.result.status == RunStatus::interrupted)
    judge_status(extreme, outcome, outcome.broken);
  judge_balances(extreme, outcome, outcome.broken);
  judge_bands(extreme, outcome, outcome.broken);
  judge_likeness(extreme, outcome, before, outcome.broken);
  outcome.run_time_s = std::chrono::duration<double>(Clock::now() - began).count();
  return outcome;
}

}  // namespace leda::solver
