#include "solver/section/key.hpp"

namespace leda {
namespace {

constexpr std::uint64_t golden = 0x9E3779B97F4A7C15;

std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9;
  x = (x ^ (x >> 27U)) * 0x94D049BB133111EB;
  return x ^ (x >> 31U);
}

}  // namespace

double unit_interval(std::uint64_t bits) {
  return (static_cast<double>(bits >> 11U) + 0.5) * 0x1p-53;
}

Key::Key(std::uint64_t seed) : state_(mixed(seed + golden)) {}

Key Key::with(std::uint64_t part) const {
  Key next = *this;
  next.state_ = mixed(state_ + golden * (2 * part + 1));
  next.state_ = mixed(next.state_ ^ part);
  return next;
}

Key Key::with(std::string_view part) const {
  // The length first, so that "ab", "c" and "a", "bc" are different keys.
  Key next = with(std::uint64_t{part.size()});
  for (const char c : part) next = next.with(std::uint64_t{static_cast<unsigned char>(c)});
  return next;
}

}  // namespace leda
