#pragma once
// The model of a run in either precision.

#include <variant>

#include "solver/kernel/model.hpp"

namespace leda::solver {

/// Double while the initial stress forms; then what the settings ask for.
using AnyModel = std::variant<Model<double>, Model<float>>;

/// Calls use(model) with the model as it is; `Model` may be const.
template <class Any, class Use>
decltype(auto) with_model(Any& any, const Use& use) {
  return std::visit(use, any);
}

/// The points as particles, in the order of their ids.
/// @pre the last step kept the motion
Particles particles_of(const AnyModel& model);

}  // namespace leda::solver
