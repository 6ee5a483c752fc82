#include "solver/section/gathered_warnings.hpp"

namespace leda {
namespace {

std::string some_of(const std::vector<std::string>& names, const std::string& between) {
  constexpr std::size_t most = 3;
  const std::size_t named = names.size() <= most ? names.size() : 2;
  std::string some = names[0];
  for (std::size_t i = 1; i < named; ++i) some += between + names[i];
  if (named < names.size()) some += " and " + std::to_string(names.size() - named) + " more";
  return some;
}

}  // namespace

void GatheredWarnings::add(const std::string& name, const std::vector<std::string>& warnings) {
  for (const std::string& text : warnings) {
    const auto [at, is_new] = index_.try_emplace(text, gathered_.size());
    if (is_new) gathered_.push_back({text, {}});
    auto& about = gathered_[at->second].about;
    if (about.empty() || about.back() != name) about.push_back(name);
  }
}

std::vector<std::string> lines_of(const GatheredWarnings& warnings, const std::string& between) {
  std::vector<std::string> lines;
  for (const GatheredWarning& one : warnings.all()) {
    lines.push_back(some_of(one.about, between) + ": " + one.text);
  }
  return lines;
}

}  // namespace leda
