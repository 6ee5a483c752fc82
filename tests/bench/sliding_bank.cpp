#include "tests/bench/sliding_bank.hpp"

#include <map>

#include "solver/run/initial_stress.hpp"
#include "solver/run/softening_stage.hpp"
#include "tests/solver/bank.hpp"

namespace leda::solver::bench {

namespace {

Section long_bank() {
  Section s = test::bank(17, 25, 27e3);
  const double crest = 150, toe = crest + s.ground[2].x - s.ground[1].x;
  s.ground = {{0, 17}, {crest, 17}, {toe, 0}, {toe + 60, 0}};
  s.base_m = -5;
  return s;
}

Seeded run_for(double seconds) {
  Bank bank;
  bank.settings.stop.max_time_s = seconds;
  RunState run = bank.start();
  find_initial_stress(run);
  if (seconds > 0) run_stage(run, StageClock::Stage::softening);
  return run.seeded;
}

}  // namespace

Bank::Bank() : section(long_bank()), settings(test::coarse()) {}

RunState Bank::start() const {
  RunState run;
  run.section = &section;
  run.settings = &settings;
  run.listener = &listener_;
  run.seeded = seed_particles(section, settings.resolution);
  run.bank = {section.ground[1], section.ground[2]};
  run.ground = surface(run.seeded);
  return run;
}

Seeded bank_after(double seconds) {
  static std::map<double, Seeded> known;
  const auto found = known.find(seconds);
  if (found != known.end()) return found->second;
  return known.emplace(seconds, run_for(seconds)).first->second;
}

}  // namespace leda::solver::bench
