#include "solver/kernel/thread_team.hpp"

namespace leda::solver {

namespace {

// Spin, then yield (there may be fewer cores than threads), then block.
constexpr int spins = 2000;
constexpr int yields = 5000;

void wait_for_change(const std::atomic<unsigned>& value, unsigned known) {
  for (int i = 0; i < spins; ++i) {
    if (value.load(std::memory_order_acquire) != known) return;
  }
  for (int i = 0; i < yields; ++i) {
    if (value.load(std::memory_order_acquire) != known) return;
    std::this_thread::yield();
  }
  value.wait(known, std::memory_order_acquire);
}

}  // namespace

ThreadTeam::ThreadTeam(int size) {
  for (int i = 1; i < size; ++i) others_.emplace_back([this] { follow(); });
}

ThreadTeam::~ThreadTeam() {
  over_ = true;
  ++round_;
  round_.notify_all();
}

void ThreadTeam::take_parts() {
  for (std::size_t i = next_++; i < count_; i = next_++) (*part_)(i);
}

void ThreadTeam::follow() {
  for (unsigned round = 0;;) {
    wait_for_change(round_, round);
    round = round_.load(std::memory_order_acquire);
    if (over_) return;
    take_parts();
    ++done_;
    done_.notify_one();
  }
}

void ThreadTeam::run(std::size_t count, const std::function<void(std::size_t)>& part) {
  part_ = &part;
  count_ = count;
  next_ = 0;
  done_ = 0;
  if (!others_.empty()) {
    ++round_;
    round_.notify_all();
  }
  take_parts();
  const auto all = static_cast<unsigned>(others_.size());
  for (unsigned done = done_; done != all; done = done_) wait_for_change(done_, done);
}

}  // namespace leda::solver
