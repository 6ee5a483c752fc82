#pragma once
// What a test brought to the disk: its program has an fsync() and an
// fdatasync() of its own, which keep a record.

#include <filesystem>
#include <vector>

namespace leda::tests {

/// Files and folders under the names they had then, in that order, since the last call.
std::vector<std::filesystem::path> take_synced_paths();

/// Whether all of them are among those, in this order.
bool in_order(const std::vector<std::filesystem::path>& wanted,
              const std::vector<std::filesystem::path>& synced);

}  // namespace leda::tests
