#include "server/documents/member_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string_view>

#include "solver/section/warnings.hpp"

namespace leda::server {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Whether the number that follows is part of a name ("S1") or says which of several ("layer 2").
bool begins_name(std::string_view before) {
  if (before.ends_with("layer ") || before.ends_with("column ")) return true;
  if (before.empty()) return false;
  return std::isalpha(static_cast<unsigned char>(before.back())) != 0 || before.back() == '_';
}

/// A text without its measured numbers.
std::string kind_of(const std::string& text) {
  std::string kind;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && (is_digit(text[end]) || (end > i && text[end] == '.'))) ++end;
    if (end == i) {
      kind += text[i++];
      continue;
    }
    kind += begins_name(kind) ? text.substr(i, end - i) : "#";
    i = end;
  }
  return kind;
}

struct Kind {
  std::string first;
  bool is_one_text = true;
  std::set<std::string> members;
};

}  // namespace

std::vector<std::string> member_lines(const GatheredWarnings& gathered, std::size_t all,
                                      const std::vector<std::string>& base) {
  std::vector<Kind> kinds;
  std::map<std::string, std::size_t> index;
  for (const GatheredWarning& one : gathered.all()) {
    if (std::ranges::find(base, one.text) != base.end()) continue;
    const auto [at, is_new] = index.try_emplace(kind_of(one.text), kinds.size());
    if (is_new) kinds.push_back({one.text, true, {}});
    Kind& kind = kinds[at->second];
    kind.is_one_text = is_new;
    kind.members.insert(one.about.begin(), one.about.end());
  }
  std::vector<std::string> lines;
  for (const Kind& kind : kinds) {
    lines.push_back(fmt::format("{} of {} members{}: {}", kind.members.size(), all,
                                kind.is_one_text ? "" : ", such as", kind.first));
  }
  return lines;
}

std::vector<std::string> member_lines(const std::vector<MemberRow>& rows, std::size_t members,
                                      const std::vector<std::string>& base) {
  GatheredWarnings gathered;
  for (const MemberRow& row : rows) {
    const bool counts = row.run == MemberRun{row.run.member} && row.run.member < members;
    if (counts && row.result) gathered.add(run_name(row.run), row.result->warnings);
  }
  return member_lines(gathered, members, base);
}

std::vector<std::string> hindcast_warnings(const HindcastFile& file,
                                           const std::vector<HindcastRow>& rows,
                                           std::size_t members) {
  std::vector<GatheredWarnings> of_members(file.cases.size());
  for (const HindcastRow& row : rows) {
    if (!row.result) continue;
    of_members[row.run.slide].add(std::to_string(row.run.member), row.result->warnings);
  }
  GatheredWarnings of_slides;
  for (std::size_t e = 0; e < file.cases.size(); ++e) {
    const auto base = warnings_of(file.cases[e].of.section, file.cases[e].of.settings);
    of_slides.add(file.plan.slides[e].name, base);
    of_slides.add(file.plan.slides[e].name, member_lines(of_members[e], members, base));
  }
  return lines_of(of_slides);
}

}  // namespace leda::server
