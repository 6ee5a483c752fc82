#pragma once
// What may be absent, as JSON.

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <type_traits>

namespace leda::server {

/// null where there is none, or it is a number that JSON does not know.
template <class T>
nlohmann::json or_null(const std::optional<T>& value) {
  if (!value) return nullptr;
  if constexpr (std::is_floating_point_v<T>) {
    if (!std::isfinite(*value)) return nullptr;
  }
  return *value;
}

}  // namespace leda::server
