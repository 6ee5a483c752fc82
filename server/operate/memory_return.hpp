#pragma once
// Memory goes back to the system where much of it was needed for a short time.

#include <malloc.h>

namespace leda::server {

/// Call before the first thread. glibc would raise its thresholds to what was freed at once, and
/// then keep as much in the arena of every thread.
inline void keep_little_free_memory() {
  mallopt(M_MMAP_THRESHOLD, 4 << 20);
  mallopt(M_TRIM_THRESHOLD, 1 << 20);
}

/// Stands before what is large for a short time, such as the layout of a job, and returns its
/// memory to the system after it: what lies between pieces that stay in use.
class MemoryReturn {
 public:
  MemoryReturn() = default;
  ~MemoryReturn() { malloc_trim(0); }
  MemoryReturn(const MemoryReturn&) = delete;
  MemoryReturn& operator=(const MemoryReturn&) = delete;
};

}  // namespace leda::server
