#pragma once
// The same warning of many sections, or of many members, told once.

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace leda {

struct GatheredWarning {
  std::string text;
  std::vector<std::string> about;  ///< names, in the order they came
};

/// Each text once, in the order the texts came.
class GatheredWarnings {
 public:
  void add(const std::string& name, const std::vector<std::string>& warnings);

  const std::vector<GatheredWarning>& all() const { return gathered_; }

 private:
  std::vector<GatheredWarning> gathered_;
  std::map<std::string, std::size_t> index_;
};

/// "S001: TEXT", "S001, S002, S003: TEXT", "S001, S002 and 56 more: TEXT".
/// @param between names
std::vector<std::string> lines_of(const GatheredWarnings& warnings,
                                  const std::string& between = ", ");

}  // namespace leda
