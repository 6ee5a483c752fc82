#pragma once
// What a command leaves: faults on standard error, and an exit code.

#include <functional>

namespace leda::server {

/// Calls a command; what it throws is told on standard error, each fault with its pointer.
/// @return its exit code; 2 where the input is at fault, 1 after any other failure
int guarded(const std::function<int()>& command);

}  // namespace leda::server
