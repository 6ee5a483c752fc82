#pragma once
// Connections that end while their client may still be sending.

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <thread>
#include <vector>

namespace leda::server {

/// Closes sockets in a thread of its own: what their clients still send is dropped for a moment,
/// else the machine would answer it with a reset, which may overtake the server's last answer.
class LingeringClose {
 public:
  /// @param most at once; more are closed without a wait
  explicit LingeringClose(std::size_t most);
  /// Closes what still lingers.
  ~LingeringClose();
  LingeringClose(const LingeringClose&) = delete;
  LingeringClose& operator=(const LingeringClose&) = delete;

  /// Takes the socket over. Never waits; safe from several threads.
  void take(int socket);

 private:
  using Clock = std::chrono::steady_clock;
  struct Closing {
    int socket = -1;
    Clock::time_point began{}, heard{};  ///< when it was taken over, and last sent something
  };

  void work();
  bool take_in();
  void drop_what_came();

  const std::size_t most_;
  std::mutex mutex_;  ///< guards these three
  std::condition_variable wake_;
  std::vector<Closing> taken_;  ///< not seen by the thread yet
  std::size_t lingering_ = 0;   ///< with those taken
  bool ending_ = false;

  std::vector<Closing> closing_;  ///< of the thread alone
  std::thread thread_;
};

}  // namespace leda::server
