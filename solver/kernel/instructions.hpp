#pragma once
// Which vector instructions the kernel runs on this processor.

#include <string>

namespace leda::solver {

/// Highway's name of the target that its dispatch takes here, in small letters: "avx2", "avx3"
/// (AVX-512), "sse4". Does not change within a process.
std::string instructions();

}  // namespace leda::solver
