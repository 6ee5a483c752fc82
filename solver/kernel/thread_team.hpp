#pragma once
// Threads that share out the parts of one step.

#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace leda::solver {

/// A few threads that stay awake between parts of a step, which take less than a millisecond. What
/// is computed must not depend on who computes it: parts write to places of their own.
class ThreadTeam {
 public:
  /// @param size threads with the caller's, at least 1
  explicit ThreadTeam(int size);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  /// Calls part(0) to part(count - 1), each once, on any thread, and returns when all are done.
  /// @pre part throws nothing
  void run(std::size_t count, const std::function<void(std::size_t)>& part);

 private:
  void take_parts();
  void follow();

  std::vector<std::jthread> others_;
  const std::function<void(std::size_t)>* part_ = nullptr;
  std::size_t count_ = 0;
  std::atomic<std::size_t> next_{0};
  std::atomic<unsigned> round_{0}, done_{0};
  std::atomic<bool> over_{false};
};

}  // namespace leda::solver
