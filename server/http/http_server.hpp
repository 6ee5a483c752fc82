#pragma once
// The table of routes behind cpp-httplib, with what that library leaves open closed.

#include <memory>
#include <stdexcept>
#include <string>

#include "server/http/site.hpp"

namespace leda::server {

class ListenError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct ListenAddress {
  std::string host;
  int port = 0;  ///< 0: any free one
};

/// From "127.0.0.1:8080". Without tokens only the loopback interface is served.
/// @throws ListenError saying what would be right
ListenAddress listen_address_from(const std::string& text, bool with_tokens = false);

class HttpServer {
 public:
  /// Binds and serves from threads of its own; site.url is set.
  /// @param origins whose pages may ask too
  /// @throws ListenError where the address is taken
  HttpServer(Site& site, const ListenAddress& address);
  /// Stops listening and ends open answers.
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

 private:
  struct Running;
  std::unique_ptr<Running> running_;
};

}  // namespace leda::server
