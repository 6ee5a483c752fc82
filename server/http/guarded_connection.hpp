#pragma once
// A connection that a slow, endless or silent client cannot hold.

#include <sys/types.h>

#include <chrono>
#include <cstddef>

#include "server/http/limits.hpp"

namespace leda::server {

/// The requests of a socket and their answers, one after the other. cpp-httplib itself bounds
/// neither the length of a header nor the time it takes, so both are watched here, byte by byte.
class GuardedConnection {
 public:
  GuardedConnection(int socket, const Limits& limits);

  /// Waits so long for the next request, with which its limits begin. What came in one piece with
  /// the request before is a part of it. False where none came.
  bool await_request(std::chrono::milliseconds most);

  bool is_readable() const;
  bool is_writable() const;
  ssize_t read(char* to, std::size_t size);
  ssize_t write(const char* from, std::size_t size);
  int socket() const { return socket_; }

  /// The client broke a limit and was told; nothing more is sent or read.
  bool is_broken_off() const { return broken_off_; }
  /// Something was received that no request was made of.
  bool has_unread() const { return at_ < end_; }

 private:
  using Clock = std::chrono::steady_clock;
  using Milliseconds = std::chrono::milliseconds;

  bool wait_for(short events, Milliseconds most) const;
  bool fill();
  bool header_is_within_limits(char next);
  bool is_too_slow(Milliseconds took, std::size_t bytes) const;
  void break_off(int status, const char* title);

  int socket_;
  const Limits& limits_;
  char buffer_[4096]{};
  std::size_t at_ = 0, end_ = 0;  ///< of what was received and not read yet
  bool broken_off_ = false;

  struct Request {
    std::size_t header_bytes = 0, body_bytes = 0, sent_bytes = 0;
    int line_ends = 0;  ///< in a row; two end the header
    bool in_header = true;
    Clock::time_point started{};  ///< its header, then its body
    Milliseconds blocked{0};      ///< waited for the client to take what is sent
  };
  Request request_;
};

/// A short answer of the server's own, for a connection that gets no other. Never waits.
void send_and_forget(int socket, int status, const char* title, const char* more_headers);

}  // namespace leda::server
