#pragma once
// A counting semaphore that never waits: what is asked for is had at once, or refused.

#include <atomic>
#include <cstddef>
#include <limits>
#include <memory>

namespace leda::server {

class Slots {
 public:
  explicit Slots(std::size_t most = std::numeric_limits<std::size_t>::max()) : most_(most) {}

  /// Given back when its last owner lets go; must not outlive the Slots.
  using Slot = std::shared_ptr<const void>;

  /// Nothing where all are taken. Safe from several threads.
  Slot take() {
    if (++taken_ <= most_) return {this, [this](const void*) { --taken_; }};
    --taken_;
    return nullptr;
  }
  std::size_t taken() const { return taken_; }

 private:
  const std::size_t most_;
  std::atomic<std::size_t> taken_{0};
};

}  // namespace leda::server
