#include "solver/run/model_of_run.hpp"

#include "solver/kernel/pack_particles.hpp"
#include "solver/run/run_state.hpp"

namespace leda::solver {

Particles particles_of(const AnyModel& model) {
  return with_model(model, [](const auto& m) { return unpack(m.packs, m.grid.h); });
}

Engine engine_of(const RunState& run) {
  return with_model(run.model, [&]<class Real>(const Model<Real>& model) -> Engine {
    return {
        .precision = sizeof(Real) == 4 ? Precision::single_precision : Precision::double_precision,
        .instructions = model.kernel->instructions,
        .time_step_factor = run.settings->time_step_factor,
        .averaged_dilation = model.grid.averages()};
  });
}

}  // namespace leda::solver
