#include "server/http/guarded_http.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "server/http/guarded_connection.hpp"

namespace leda::server {
namespace {

constexpr int requests_of_a_connection = 1000;
constexpr int idle_ms = 1000;  // between two requests of a connection
constexpr int backlog = 128;

/// What a thread is to do with its connection: the library's callbacks have no room for it.
struct ThisThread {
  bool turns_away = false;  ///< set while the thread that accepts has to
  bool closes_after_answer = false;
};

ThisThread& this_thread() {
  static thread_local ThisThread own;
  return own;
}

/// Lets the client read its answer before the connection is cut: what it still sends is dropped
/// for a moment, else the machine would answer it with a reset.
void linger(socket_t socket) {
  constexpr int most_reads = 1024;
  char dropped[16'384];
  ::shutdown(socket, SHUT_WR);
  for (int i = 0; i < most_reads; ++i) {
    pollfd one{socket, POLLIN, 0};
    if (poll(&one, 1, 500) <= 0 || recv(socket, dropped, sizeof(dropped), 0) <= 0) return;
  }
}

/// A fixed number of threads and of waiting connections. One more is turned away at once, by the
/// thread that accepted it.
class BoundedPool final : public httplib::TaskQueue {
 public:
  BoundedPool(std::size_t threads, std::size_t most_waiting) : most_waiting_(most_waiting) {
    for (std::size_t i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
  }

  void enqueue(std::function<void()> connection) override {
    {
      const std::lock_guard lock(mutex_);
      if (waiting_.size() < most_waiting_) {
        waiting_.push_back(std::move(connection));
        wake_.notify_one();
        return;
      }
    }
    this_thread().turns_away = true;
    connection();
    this_thread().turns_away = false;
  }

  void shutdown() override {
    {
      const std::lock_guard lock(mutex_);
      ending_ = true;
    }
    wake_.notify_all();
    for (auto& thread : threads_) thread.join();
  }

 private:
  void work() {
    for (;;) {
      std::function<void()> connection;
      {
        std::unique_lock lock(mutex_);
        wake_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
        if (waiting_.empty()) return;
        connection = std::move(waiting_.front());
        waiting_.pop_front();
      }
      connection();
    }
  }

  std::size_t most_waiting_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<std::function<void()>> waiting_;
  bool ending_ = false;
  std::vector<std::thread> threads_;
};

bool has_something_to_read(socket_t socket) {
  pollfd one{socket, POLLIN, 0};
  return poll(&one, 1, idle_ms) > 0;
}

}  // namespace

void close_after_this_answer() { this_thread().closes_after_answer = true; }

GuardedHttp::GuardedHttp(const Limits& limits, std::size_t threads) : limits_(limits) {
  const std::size_t waiting = limits.connections > threads ? limits.connections - threads : 1;
  new_task_queue = [threads, waiting] {
    return std::make_unique<BoundedPool>(threads, waiting).release();
  };
  // Not SO_REUSEPORT, as the library would: two servers would share a port without a word.
  set_socket_options([this](socket_t socket) {
    listening_ = socket;
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
  });
}

void GuardedHttp::lengthen_backlog() const {
  if (listening_ >= 0) ::listen(listening_, backlog);
}

bool GuardedHttp::process_and_close_socket(socket_t socket) {
  bool answered = false;
  if (this_thread().turns_away) {
    send_and_forget(socket, 503, "Too many connections", "Retry-After: 1\r\n");
  } else {
    const auto counted = open_.take();
    answered = answer_requests(socket);
  }
  if (this_thread().closes_after_answer) linger(socket);
  this_thread().closes_after_answer = false;
  ::shutdown(socket, SHUT_RDWR);
  ::close(socket);
  return answered;
}

bool GuardedHttp::answer_requests(socket_t socket) {
  bool answered = false;
  for (int left = requests_of_a_connection; left > 0 && !ending_; --left) {
    if (!has_something_to_read(socket)) break;
    GuardedConnection connection(socket, limits_);
    bool closed = false;
    // The library's own ranges have wrong lengths beyond an end; send() has those of Leda.
    const auto without_ranges = [](httplib::Request& request) { request.ranges.clear(); };
    answered = process_request(connection, left == 1, closed, without_ranges);
    if (!answered || closed || this_thread().closes_after_answer || connection.is_broken_off())
      break;
  }
  return answered;
}

}  // namespace leda::server
