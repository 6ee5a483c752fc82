#pragma once
// cpp-httplib's server with a limit on connections and on what each of them may take. What depends
// on inner parts of that library, which change with its releases, is in guarded_http.cpp and
// nowhere else: the architecture test sees to it.

#include <cstddef>
#include <memory>

#include "server/http/limits.hpp"

namespace httplib {
class Server;
struct Response;
}  // namespace httplib

namespace leda::server {

/// The connection of this thread's request ends with its answer: something of the request was left
/// unread, and the library would take it for the next request.
void close_after_this_answer();

/// Whether an answer has a body already, or something that gives one.
bool has_content(const httplib::Response& response);

class GuardedHttp {
 public:
  /// @param threads that answer; connections beyond wait their turn
  GuardedHttp(const Limits& limits, std::size_t threads);
  ~GuardedHttp();
  GuardedHttp(const GuardedHttp&) = delete;
  GuardedHttp& operator=(const GuardedHttp&) = delete;

  /// To set handlers, bind and listen.
  httplib::Server& server();
  /// Longer than the five that the library asks for: a browser opens six connections at once.
  void lengthen_backlog() const;
  void end_soon();
  std::size_t connections() const;  ///< open now

 private:
  class Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace leda::server
