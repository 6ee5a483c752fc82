#pragma once
// A thread pool with a bounded queue.

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace leda::server {

class BoundedPool {
 public:
  using Task = std::function<void()>;

  /// @param threads that work, a fixed number  @param most_waiting tasks that may wait for one
  BoundedPool(std::size_t threads, std::size_t most_waiting);
  /// Does what waits, then ends. @pre shutdown() was called, or no task is under way
  ~BoundedPool();
  BoundedPool(const BoundedPool&) = delete;
  BoundedPool& operator=(const BoundedPool&) = delete;

  /// False where as many wait as may: the task is the caller's still. Safe from several threads.
  bool take(const Task& task);
  /// Does what waits, then ends its threads.
  void shutdown();

 private:
  void work();

  std::size_t most_waiting_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<Task> waiting_;
  bool ending_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace leda::server
