#pragma once
// What a random number depends on. A number is a function of its key alone, never of what was drawn
// before it: so the draws of a member are the same in any order, on any worker, at any try.

#include <cstdint>
#include <string_view>

namespace leda {

/// 53 bits as a number within (0, 1), never 0 or 1.
double unit_interval(std::uint64_t bits);

/// A value type; SplitMix64's finalizer (Steele, Lea and Flood 2014) over each part in turn.
class Key {
 public:
  explicit Key(std::uint64_t seed);

  Key with(std::uint64_t part) const;
  Key with(std::string_view part) const;

  std::uint64_t bits() const { return state_; }
  double uniform() const { return unit_interval(state_); }

 private:
  std::uint64_t state_;
};

}  // namespace leda
