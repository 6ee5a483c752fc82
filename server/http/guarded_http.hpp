#pragma once
// cpp-httplib's server with a limit on connections and on what each of them may take.
// Includes cpp-httplib.

#include <httplib.h>

#include <atomic>

#include "server/http/limits.hpp"
#include "server/http/slots.hpp"

namespace leda::server {

/// The connection of this thread's request ends with its answer: something of the request was left
/// unread, and the library would take it for the next request.
void close_after_this_answer();

class GuardedHttp final : public httplib::Server {
 public:
  /// @param threads that answer; connections beyond wait their turn
  GuardedHttp(const Limits& limits, std::size_t threads);

  /// Longer than the five that the library asks for: a browser opens six connections at once.
  void lengthen_backlog() const;
  void end_soon() { ending_ = true; }
  std::size_t connections() const { return open_.taken(); }

 private:
  bool process_and_close_socket(socket_t socket) override;
  bool answer_requests(socket_t socket);

  const Limits limits_;
  socket_t listening_ = -1;
  Slots open_;
  std::atomic<bool> ending_{false};
};

}  // namespace leda::server
