#pragma once
// The last state of a run that passed every check: what an unstable run ends with.

#include <array>
#include <cstdint>
#include <vector>

#include "solver/run/model_of_run.hpp"

namespace leda::solver {

/// Values that a result or a frame shows, in single precision, which is what a frame holds: 44
/// bytes a particle. An unstable state may be finite and still be wrong, or not finite at all;
/// neither reaches a result.
class LastGood {
 public:
  /// @return false, and what was kept before stays, where a value is not finite in single precision
  bool keep(const AnyModel& model, double time_s);

  /// Puts the kept values back, by id; without effect where nothing was kept.
  /// @param particles those that were kept, in any order
  /// @return the time of the state, s
  double restore(Particles& particles) const;

  bool empty() const { return id_.empty(); }

 private:
  static constexpr std::size_t shown = 10;
  std::array<std::vector<float>, shown> values_;
  std::vector<std::int32_t> id_;
  double time_s_ = 0;
};

}  // namespace leda::solver
