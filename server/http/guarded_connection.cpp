#include "server/http/guarded_connection.hpp"

#include <poll.h>
#include <sys/socket.h>

#include <string>

namespace leda::server {

void send_and_forget(int socket, int status, const char* title, const char* more_headers) {
  const std::string body = "{\"type\":\"about:blank\",\"title\":\"" + std::string(title) +
                           "\",\"status\":" + std::to_string(status) + ",\"detail\":\"" + title +
                           "\",\"instance\":\"\"}\n";
  const std::string answer = "HTTP/1.1 " + std::to_string(status) + " " + title +
                             "\r\nContent-Type: application/problem+json\r\nConnection: close\r\n" +
                             more_headers + "Content-Length: " + std::to_string(body.size()) +
                             "\r\n\r\n" + body;
  [[maybe_unused]] const ssize_t sent =
      send(socket, answer.data(), answer.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
}

GuardedConnection::GuardedConnection(int socket, const Limits& limits)
    : socket_(socket), limits_(limits) {}

bool GuardedConnection::wait_for(short events, Milliseconds most) const {
  pollfd one{socket_, events, 0};
  return poll(&one, 1, static_cast<int>(most.count())) > 0;
}

bool GuardedConnection::await_request(Milliseconds most) {
  if (!has_unread() && !wait_for(POLLIN, most)) return false;
  request_ = {};
  return true;
}

bool GuardedConnection::is_readable() const {
  return !broken_off_ && (at_ < end_ || wait_for(POLLIN, limits_.pause));
}

/// Also false once the client has hung up: an event stream would otherwise hold its thread until
/// there is something to send.
bool GuardedConnection::is_writable() const {
  if (broken_off_ || !wait_for(POLLOUT, limits_.pause)) return false;
  char next = 0;
  return recv(socket_, &next, 1, MSG_PEEK | MSG_DONTWAIT) != 0;
}

void GuardedConnection::break_off(int status, const char* title) {
  if (!broken_off_) send_and_forget(socket_, status, title, "");
  broken_off_ = true;
}

/// Of a body or an answer.
bool GuardedConnection::is_too_slow(Milliseconds took, std::size_t bytes) const {
  const std::chrono::duration<double> beyond = took - limits_.grace;
  return beyond.count() * static_cast<double>(limits_.least_bytes_a_s) > static_cast<double>(bytes);
}

bool GuardedConnection::fill() {
  if (request_.started == Clock::time_point{}) request_.started = Clock::now();
  const auto took = std::chrono::duration_cast<Milliseconds>(Clock::now() - request_.started);
  const bool too_slow =
      request_.in_header ? took > limits_.header_time : is_too_slow(took, request_.body_bytes);
  if (too_slow || !wait_for(POLLIN, limits_.pause)) {
    break_off(408, "Request Timeout");
    return false;
  }
  const ssize_t count = recv(socket_, buffer_, sizeof(buffer_), 0);
  if (count <= 0) return false;
  at_ = 0;
  end_ = static_cast<std::size_t>(count);
  return true;
}

bool GuardedConnection::header_is_within_limits(char next) {
  if (++request_.header_bytes > limits_.header_bytes) {
    break_off(431, "Request Header Fields Too Large");
    return false;
  }
  if (next == '\n') {
    if (++request_.line_ends == 2) {
      request_.in_header = false;
      request_.started = Clock::now();
    }
  } else if (next != '\r') {
    request_.line_ends = 0;
  }
  return true;
}

ssize_t GuardedConnection::read(char* to, std::size_t size) {
  if (broken_off_) return -1;
  if (at_ == end_ && !fill()) return broken_off_ ? -1 : 0;
  std::size_t count = 0;
  while (count < size && at_ < end_) {
    const char next = buffer_[at_++];
    if (request_.in_header && !header_is_within_limits(next)) return -1;
    if (!request_.in_header) ++request_.body_bytes;
    to[count++] = next;
  }
  return static_cast<ssize_t>(count);
}

ssize_t GuardedConnection::write(const char* from, std::size_t size) {
  // What the library still wants to say after a break is dropped: the client was told already.
  if (broken_off_) return static_cast<ssize_t>(size);
  const auto before = Clock::now();
  const bool ready = wait_for(POLLOUT, limits_.pause);
  request_.blocked += std::chrono::duration_cast<Milliseconds>(Clock::now() - before);
  if (!ready || is_too_slow(request_.blocked, request_.sent_bytes)) {
    broken_off_ = true;
    return -1;
  }
  const ssize_t sent = send(socket_, from, size, MSG_NOSIGNAL);
  if (sent > 0) request_.sent_bytes += static_cast<std::size_t>(sent);
  return sent;
}

}  // namespace leda::server
