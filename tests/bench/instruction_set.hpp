#pragma once
// The instruction set that kernels run with, chosen by name, for what compares two of them.

#include <hwy/targets.h>

#include <cctype>
#include <string>
#include <vector>

namespace leda::solver::bench {

/// "avx2", "sse4", "avx3" ...
inline std::string name_of(std::int64_t target) {
  std::string name = hwy::TargetName(target);
  for (char& c : name) c = static_cast<char>(std::tolower(c));
  return name;
}

/// From now on kernel() is that of this instruction set.
/// @return false where this processor does not have it; nothing is changed then
inline bool use_instructions(const std::string& name) {
  hwy::DisableTargets(0);
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    if (name_of(target) != name) continue;
    hwy::DisableTargets(~target);
    return true;
  }
  return false;
}

}  // namespace leda::solver::bench
