#include "server/http/guarded_http.hpp"

#include <arpa/inet.h>
#include <httplib.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstring>
#include <utility>

#include "server/http/bounded_pool.hpp"
#include "server/http/guarded_connection.hpp"
#include "server/http/lingering_close.hpp"
#include "server/operate/slots.hpp"

// Of cpp-httplib 0.11: the private virtual process_and_close_socket(), the protected
// process_request(), the pure virtuals of Stream and TaskQueue, Response::content_length_.

namespace leda::server {
namespace {

constexpr int requests_of_a_connection = 1000;
constexpr std::chrono::milliseconds idle{1000};  // between two requests of a connection
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

/// A connection beyond those that may wait is turned away at once, by the thread that accepted it.
class Queue final : public httplib::TaskQueue {
 public:
  Queue(std::size_t threads, std::size_t most_waiting) : pool_(threads, most_waiting) {}

  void enqueue(std::function<void()> connection) override {
    if (pool_.take(connection)) return;
    this_thread().turns_away = true;
    connection();
    this_thread().turns_away = false;
  }
  void shutdown() override { pool_.shutdown(); }

 private:
  BoundedPool pool_;
};

void read_address(const sockaddr_storage& from, std::string& ip, int& port) {
  char text[INET6_ADDRSTRLEN] = "";
  if (from.ss_family == AF_INET) {
    sockaddr_in v4{};
    std::memcpy(&v4, &from, sizeof(v4));
    inet_ntop(AF_INET, &v4.sin_addr, text, sizeof(text));
    port = ntohs(v4.sin_port);
  } else if (from.ss_family == AF_INET6) {
    sockaddr_in6 v6{};
    std::memcpy(&v6, &from, sizeof(v6));
    inet_ntop(AF_INET6, &v6.sin6_addr, text, sizeof(text));
    port = ntohs(v6.sin6_port);
  }
  ip = text;
}

/// A guarded connection as the library wants it.
class GuardedStream final : public httplib::Stream {
 public:
  explicit GuardedStream(GuardedConnection& of) : of_(of) {}

  bool is_readable() const override { return of_.is_readable(); }
  bool is_writable() const override { return of_.is_writable(); }
  ssize_t read(char* to, std::size_t size) override { return of_.read(to, size); }
  ssize_t write(const char* from, std::size_t size) override { return of_.write(from, size); }
  socket_t socket() const override { return of_.socket(); }
  void get_remote_ip_and_port(std::string& ip, int& port) const override {
    address(getpeername, ip, port);
  }
  void get_local_ip_and_port(std::string& ip, int& port) const override {
    address(getsockname, ip, port);
  }

 private:
  template <class Ask>
  void address(const Ask& ask, std::string& ip, int& port) const {
    sockaddr_storage found{};
    socklen_t size = sizeof(found);
    if (ask(of_.socket(), reinterpret_cast<sockaddr*>(&found), &size) == 0) {
      read_address(found, ip, port);
    }
  }

  GuardedConnection& of_;
};

}  // namespace

void close_after_this_answer() { this_thread().closes_after_answer = true; }

bool has_content(const httplib::Response& response) {
  return !response.body.empty() || response.content_length_ > 0;
}

class GuardedHttp::Inside final : public httplib::Server {
 public:
  Inside(const Limits& limits, std::size_t threads)
      : limits_(limits), lingering_(limits.connections) {
    const std::size_t waiting = limits.connections > threads ? limits.connections - threads : 1;
    new_task_queue = [threads, waiting] {
      return std::make_unique<Queue>(threads, waiting).release();
    };
    // Not SO_REUSEPORT, as the library would: two servers would share a port without a word.
    set_socket_options([this](socket_t socket) {
      listening_ = socket;
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
    });
  }

  void lengthen_backlog() const {
    if (listening_ >= 0) ::listen(listening_, backlog);
  }
  void end_soon() { ending_ = true; }
  std::size_t connections() const { return open_.taken(); }

 private:
  bool process_and_close_socket(socket_t socket) override {
    if (this_thread().turns_away) {
      send_and_forget(socket, 503, "Too many connections", "Retry-After: 1\r\n");
      lingering_.take(socket);
      return false;
    }
    const auto counted = open_.take();
    GuardedConnection connection(socket, limits_);
    const bool answered = answer_requests(connection);
    const bool unread = std::exchange(this_thread().closes_after_answer, false) ||
                        connection.is_broken_off() || connection.has_unread();
    if (unread) {
      lingering_.take(socket);
    } else {
      ::shutdown(socket, SHUT_RDWR);
      ::close(socket);
    }
    return answered;
  }

  bool answer_requests(GuardedConnection& connection) {
    GuardedStream stream(connection);
    bool answered = false;
    for (int left = requests_of_a_connection; left > 0 && !ending_; --left) {
      if (!connection.await_request(idle)) break;
      bool closed = false;
      // The library's own ranges have wrong lengths beyond an end; send() has those of Leda.
      const auto without_ranges = [](httplib::Request& request) { request.ranges.clear(); };
      answered = process_request(stream, left == 1, closed, without_ranges);
      if (!answered || closed || this_thread().closes_after_answer || connection.is_broken_off())
        break;
    }
    return answered;
  }

  const Limits limits_;
  socket_t listening_ = -1;
  Slots open_;
  LingeringClose lingering_;
  std::atomic<bool> ending_{false};
};

GuardedHttp::GuardedHttp(const Limits& limits, std::size_t threads)
    : inside_(std::make_unique<Inside>(limits, threads)) {}
GuardedHttp::~GuardedHttp() = default;

httplib::Server& GuardedHttp::server() { return *inside_; }
void GuardedHttp::lengthen_backlog() const { inside_->lengthen_backlog(); }
void GuardedHttp::end_soon() { inside_->end_soon(); }
std::size_t GuardedHttp::connections() const { return inside_->connections(); }

}  // namespace leda::server
