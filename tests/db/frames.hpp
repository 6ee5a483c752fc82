#pragma once
// Made-up frames for the tests of result files.

#include <cstddef>

#include "solver/section/frame.hpp"

namespace leda::db::samples {

/// Every value differs from its neighbours in array, particle and time.
inline Frame frame(double time_s, std::size_t particles) {
  Frame f;
  f.time_s = time_s;
  float seed = static_cast<float>(time_s);
  for (const FrameField& field : frame_fields) {
    seed += 1000;
    for (std::size_t i = 0; i < particles; ++i)
      (f.*field.values).push_back(seed + static_cast<float>(i) / 3.0F);
  }
  for (std::size_t i = 0; i < particles; ++i) f.material.push_back(static_cast<int>(i % 3));
  return f;
}

}  // namespace leda::db::samples
