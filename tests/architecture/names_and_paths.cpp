#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

#include "tests/architecture/house_rules.hpp"

namespace leda::architecture {

std::vector<Breach> drawers(const SourceTree& tree) {
  static const std::set<std::string> names = {"util",   "utils", "utility", "utilities",
                                              "common", "misc",  "helper",  "helpers"};
  std::vector<Breach> found;
  for (const auto& [file, text] : tree)
    for (const auto& part : std::filesystem::path(file))
      if (names.contains(part.stem().string()))
        found.push_back({file, 0, part.string() + " does not say what is in it"});
  return found;
}

std::vector<Breach> strays_at_the_top(const SourceTree& tree) {
  static const std::set<std::string> at_home = {"CMakeLists.txt", "CMakePresets.json", "LICENSE"};
  std::vector<Breach> found;
  for (const auto& [file, text] : tree) {
    const bool in_a_folder = file.find('/') != std::string::npos;
    if (in_a_folder || file.starts_with('.') || file.ends_with(".md") || at_home.contains(file))
      continue;
    found.push_back({file, 0, "nothing of this name belongs at the top"});
  }
  return found;
}

std::vector<Breach> machine_paths(const SourceTree& tree) {
  // Put together here, so that this file does not name one itself. A path on this machine begins
  // a word; the middle of an address, or what follows ${HOME}, is none.
  static const std::regex path(std::string(R"((^|[\s"'`=:,;(<>\[])/)") + "(work|root)/");
  std::vector<Breach> found;
  for (const auto& [file, text] : tree) {
    if (!is_text(text)) continue;
    std::istringstream lines(text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number)
      if (std::regex_search(line, path)) found.push_back({file, number, "a machine path: " + line});
  }
  return found;
}

std::vector<Breach> long_lines(const SourceTree& tree) {
  constexpr std::size_t most = 130;
  std::vector<Breach> found;
  for (const auto& [file, text] : tree) {
    if (!(file.ends_with(".ts") || file.ends_with(".mjs")) || file.ends_with("/words.ts")) continue;
    std::istringstream lines(text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
      // Continuation bytes of UTF-8 are no characters.
      const auto characters = std::count_if(line.begin(), line.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
      });
      if (static_cast<std::size_t>(characters) > most)
        found.push_back({file, number, "a long line"});
    }
  }
  return found;
}

}  // namespace leda::architecture
