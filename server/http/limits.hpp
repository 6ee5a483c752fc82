#pragma once
// What one client and one request may take of the server.

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace leda::server {

struct Limits {
  // Connections
  std::size_t connections = 256;  ///< at once; more are answered 503
  std::size_t streams = 16;       ///< of events, open at once
  std::size_t header_bytes = 32 << 10;
  std::chrono::milliseconds header_time{10'000};  ///< from its first byte to its last
  std::chrono::milliseconds pause{5'000};         ///< without a byte, in either direction
  /// Bodies and answers may take this long, and beyond it a second for so many bytes: a document of
  /// 16 MiB takes 18 minutes at most.
  std::chrono::milliseconds grace{30'000};
  std::size_t least_bytes_a_s = 16 << 10;

  // Requests
  std::uint64_t raster_bytes = std::uint64_t{4} << 30;  ///< of a DEM's file
  std::size_t document_bytes = std::size_t{16} << 20;
  std::size_t registrations = 2;  ///< of DEMs, at once
};

}  // namespace leda::server
