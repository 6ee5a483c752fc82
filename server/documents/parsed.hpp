#pragma once
// What parsing a document gives: its value, or every fault found in it.

#include <optional>
#include <vector>

#include "solver/section/validate.hpp"

namespace leda::server {

/// Exactly one of the two: a value and no faults, or faults and no value.
template <class T>
struct Parsed {
  std::optional<T> value;
  std::vector<Fault> faults;
  explicit operator bool() const { return value.has_value(); }
};

}  // namespace leda::server
