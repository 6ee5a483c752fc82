#pragma once
// The bank the benchmarks of the solver step.

#include "solver/run/run_state.hpp"
#include "tests/bench/bank_case.hpp"

namespace leda::solver::bench {

/// A bank like Sainte-Monique's (thesis, chapter 4) at cells of 1 m: 17 m high over 5 m of the same
/// clay, 150 m of plateau, 60 m of floor.
class Bank {
 public:
  explicit Bank(const BankCase& how = bank_cases[0]);
  /// Seeded, before the initial stress is found. It refers to this object.
  RunState start() const;

  Section section;
  RunSettings settings;

 private:
  Listener listener_;
};

/// The bank `seconds` after softening is on, with its particles; 0: at rest.
const Seeded& bank_after(double seconds, const BankCase& how);

}  // namespace leda::solver::bench
