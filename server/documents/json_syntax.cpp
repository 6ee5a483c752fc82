#include "server/documents/json_syntax.hpp"

#include <fmt/format.h>

#include <set>
#include <string>

#include "solver/section/fault_list.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

/// Walks through the text once and keeps nothing but the way to the current value.
class SyntaxCheck : public nlohmann::json_sax<json> {
 public:
  FaultList faults;

  bool null() override { return next(); }
  bool boolean(bool /*value*/) override { return next(); }
  bool number_integer(number_integer_t /*value*/) override { return next(); }
  bool number_unsigned(number_unsigned_t /*value*/) override { return next(); }
  bool number_float(number_float_t /*value*/, const string_t& /*text*/) override { return next(); }
  bool string(string_t& /*value*/) override { return next(); }
  bool binary(binary_t& /*value*/) override { return next(); }

  bool start_object(std::size_t /*members*/) override { return enter(true); }
  bool start_array(std::size_t /*members*/) override { return enter(false); }
  bool end_object() override { return leave(); }
  bool end_array() override { return leave(); }

  bool key(string_t& name) override {
    Level& level = levels_.back();
    level.key = name;
    if (!level.keys.insert(name).second) faults.add(pointer(), "occurs twice, must occur once");
    return true;
  }

  bool parse_error(std::size_t /*at*/, const std::string& /*token*/,
                   const json::exception& error) override {
    // nlohmann: 101 syntax, with line and column; 406 a number beyond the range of a double.
    faults.add(error.id == 406 ? pointer() : "",
               error.id == 406 ? "is a number too large to be read" : reason(error.what()));
    return false;
  }

 private:
  struct Level {
    bool is_object = false;
    std::size_t index = 0;
    std::string key;
    std::set<std::string> keys;
  };

  static std::string reason(const std::string& what) {
    const auto start = what.find("] ");
    return "is not JSON: " + (start == std::string::npos ? what : what.substr(start + 2));
  }

  std::string pointer() const {
    std::string at;
    for (const Level& level : levels_) {
      at += '/';
      at += level.is_object ? pointer_part(level.key) : std::to_string(level.index);
    }
    return at;
  }

  bool next() {
    if (!levels_.empty() && !levels_.back().is_object) ++levels_.back().index;
    return true;
  }

  bool enter(bool is_object) {
    if (levels_.size() >= std::size_t(most_nesting)) {
      faults.add("", fmt::format("is nested deeper than {} levels", most_nesting));
      return false;
    }
    levels_.push_back({is_object, 0, {}, {}});
    return true;
  }

  bool leave() {
    levels_.pop_back();
    return next();
  }

  std::vector<Level> levels_;
};

}  // namespace

Parsed<json> parse_json(std::string_view text) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    return {std::nullopt, {{"", "is empty, must be a JSON object"}}};
  }
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {
    return {std::nullopt, {{"", "is written in UTF-16: save it as UTF-8"}}};
  }
  SyntaxCheck check;
  json::sax_parse(text, &check);
  if (auto faults = check.faults.take(); !faults.empty()) return {std::nullopt, std::move(faults)};
  return {json::parse(text), {}};
}

}  // namespace leda::server
