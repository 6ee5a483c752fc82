#include "solver/run/model_of_run.hpp"

#include "solver/kernel/pack_particles.hpp"

namespace leda::solver {

Particles particles_of(const AnyModel& model) {
  return with_model(model, [](const auto& m) { return unpack(m.packs, m.grid.h); });
}

}  // namespace leda::solver
