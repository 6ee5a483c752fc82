#include "tests/bench/sliding_bank.hpp"

#include <map>
#include <string>

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

Seeded run_for(double seconds, const BankCase& how) {
  Bank bank(how);
  bank.settings.stop.max_time_s = seconds;
  RunState run = bank.start();
  find_initial_stress(run);
  begin_moving(run);
  if (seconds > 0) run_stage(run, StageClock::Stage::softening);
  run.seeded.particles = particles_of(run.model);
  return run.seeded;
}

}  // namespace

Bank::Bank(const BankCase& how) : section(how.of(long_bank())), settings(test::coarse()) {}

RunState Bank::start() const {
  RunState run;
  run.section = &section;
  run.settings = &settings;
  run.listener = &listener_;
  run.seeded = seed_particles(section, settings.resolution);
  run.bank = {section.ground[1], section.ground[2]};
  begin_quiet(run);
  run.ground = surface(run.model, run.seeded);
  return run;
}

const Seeded& bank_after(double seconds, const BankCase& how) {
  static std::map<std::pair<double, std::string>, Seeded> known;
  const std::pair key(seconds, std::string(how.name));
  const auto found = known.find(key);
  return found != known.end() ? found->second
                              : known.emplace(key, run_for(seconds, how)).first->second;
}

}  // namespace leda::solver::bench
