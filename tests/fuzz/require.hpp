#pragma once
// What holds for every input of a fuzzer; a breach ends the program, as a crash does.

#include <cstdio>
#include <cstdlib>

#include "server/documents/parsed.hpp"

namespace leda::fuzz {

inline void require(bool holds, const char* otherwise) {
  if (holds) return;
  std::fprintf(stderr, "breach: %s\n", otherwise);
  std::abort();
}

/// A value or faults, never both and never neither; each fault has a pointer and a message.
template <class T>
void require_faults_or_value(const server::Parsed<T>& parsed) {
  require(parsed.value.has_value() == parsed.faults.empty(), "value and faults, or neither");
  for (const Fault& fault : parsed.faults) {
    require(fault.pointer.empty() || fault.pointer[0] == '/', "a fault without a pointer");
    require(!fault.message.empty(), "a fault without a message");
  }
}

}  // namespace leda::fuzz
