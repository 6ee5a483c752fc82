#pragma once
// What one job, and all of them together, may take.

#include <cstddef>

namespace leda::server {

struct JobLimits {
  std::size_t unfinished_jobs = 200;  ///< with those that are being laid out
  std::size_t layouts = 8;            ///< being laid out at once, dry runs among them
  std::size_t sections = 20'000;      ///< of a job
  std::size_t members = 200'000;  ///< of all sections of a job, repeats and finer runs with them
  double particles = 5e9;         ///< of all runs of a job together
};

}  // namespace leda::server
