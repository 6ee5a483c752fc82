#pragma once
// Another program that writes to the store, and does not finish.

#include <filesystem>

struct sqlite3;

namespace leda::tests {

/// Holds SQLite's lock for writing while it lives. @throws std::runtime_error
class HeldStore {
 public:
  explicit HeldStore(const std::filesystem::path& store);
  ~HeldStore();
  HeldStore(const HeldStore&) = delete;
  HeldStore& operator=(const HeldStore&) = delete;

 private:
  sqlite3* connection_ = nullptr;
};

}  // namespace leda::tests
