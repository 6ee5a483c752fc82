#pragma once
// Threads that do the same costly thing, a few at once, in the order in which they asked.

#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace leda::db {

class Turns {
 public:
  explicit Turns(std::uint64_t at_once) : at_once_(at_once) {}

  /// Begins when it is this thread's turn, and ends with its scope.
  class Turn {
   public:
    explicit Turn(Turns& of) : of_(of) {
      std::unique_lock lock(of_.mutex_);
      const std::uint64_t own = of_.asked_++;
      of_.ended_one_.wait(lock, [&] { return own < of_.ended_ + of_.at_once_; });
    }
    ~Turn() {
      {
        const std::lock_guard lock(of_.mutex_);
        ++of_.ended_;
      }
      of_.ended_one_.notify_all();
    }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

   private:
    Turns& of_;
  };

 private:
  const std::uint64_t at_once_;
  std::mutex mutex_;
  std::condition_variable ended_one_;
  std::uint64_t asked_ = 0, ended_ = 0;
};

}  // namespace leda::db
