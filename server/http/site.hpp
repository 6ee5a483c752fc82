#pragma once
// A service as it is reached over HTTP: where, by whom, and how much of it at once.

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>

#include "db/turns.hpp"
#include "server/http/auth.hpp"
#include "server/http/cors.hpp"
#include "server/http/limits.hpp"
#include "server/jobs/service.hpp"
#include "server/operate/slots.hpp"

namespace leda::server {

struct SiteOptions {
  Limits limits;
  Tokens tokens;           ///< none: only for the loopback interface
  AllowedOrigins origins;  ///< whose pages may ask too
  std::string public_url;  ///< how clients reach it, behind a proxy; empty: as it listens
};

/// What handlers get. Safe from several threads.
struct Site {
  explicit Site(Service& of, const SiteOptions& options = {})
      : service(of),
        limits(options.limits),
        tokens(options.tokens),
        origins(options.origins),
        public_url(options.public_url) {}

  Service& service;
  const Limits limits;
  const Tokens tokens;
  const AllowedOrigins origins;
  const std::string public_url;
  std::string url;                ///< "http://127.0.0.1:8080", where it is served
  db::Turns hillshades{1};        ///< each reads a whole DEM
  db::Turns pages{8};             ///< of many sections: each takes megabytes while it is made
  Slots streams{limits.streams};  ///< of events
  Slots registrations{limits.registrations};  ///< of DEMs
  std::atomic<bool> stopping{false};
  std::function<std::size_t()> connections = [] { return std::size_t{0}; };  ///< open now
};

}  // namespace leda::server
