#include "server/documents/uncertain_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace leda::server {
namespace {

using nlohmann::json;

/// The parts between the slashes, as written (RFC 6901).
std::vector<std::string> parts_of(const std::string& path) {
  std::vector<std::string> parts;
  for (std::size_t begin = 1; begin <= path.size();) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    parts.push_back(path.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

std::string unescaped(const std::string& part) {
  std::string key;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const bool escape = part[i] == '~' && i + 1 < part.size();
    key += !escape ? part[i] : part[i + 1] == '1' ? '/' : '~';
    if (escape) ++i;
  }
  return key;
}

/// The members of an object or a list that a part of a path names.
std::vector<std::pair<std::string, const json*>> members_at(const json& value,
                                                            const std::string& part) {
  std::vector<std::pair<std::string, const json*>> members;
  if (!value.is_structured()) return members;
  for (const auto& [key, member] : value.items()) {
    if (part == "*" || key == unescaped(part)) members.emplace_back(pointer_part(key), &member);
  }
  return members;
}

std::string what_is_there(const json& value) {
  if (value.is_array()) return fmt::format("a list of {} items", value.size());
  if (!value.is_object()) return kind_of(value);
  std::string names;
  for (const auto& [key, member] : value.items()) names += (names.empty() ? "" : ", ") + key;
  return names.empty() ? "an empty object" : names;
}

}  // namespace

UncertainDocument::UncertainDocument(json document, const std::vector<InputPlace>& places,
                                     const std::string& at, FaultList& faults)
    : document_(std::move(document)) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    // A path that could not be read was told.
    if (!places[i].path.empty()) {
      look_up(places[i], i, fmt::format("{}/inputs/{}/path", at, i), faults);
    }
  }
  std::stable_partition(targets_.begin(), targets_.end(),
                        [](const Target& target) { return target.apply == Apply::set; });
}

void UncertainDocument::look_up(const InputPlace& place, std::size_t input, const std::string& at,
                                FaultList& faults) {
  if (!place.path.starts_with('/')) {
    faults.add(at, "is \"" + place.path + "\", must be a JSON pointer, which starts with /");
    return;
  }
  std::vector<std::pair<std::string, const json*>> found{{"", &document_}};
  for (const std::string& part : parts_of(place.path)) {
    std::vector<std::pair<std::string, const json*>> next;
    for (const auto& [pointer, value] : found) {
      for (const auto& [key, member] : members_at(*value, part)) {
        next.emplace_back(pointer + "/" + key, member);
      }
    }
    if (next.empty()) {
      const auto& [pointer, value] = found.front();
      faults.add(at, "is \"" + place.path + "\", which names nothing: " +
                         (part == "*" ? "* matches nothing" : "there is no " + part) + " in " +
                         (pointer.empty() ? "the document" : pointer) + ", which has " +
                         what_is_there(*value));
      return;
    }
    found = std::move(next);
  }
  for (const auto& [pointer, value] : found) {
    add_target(*value, pointer, place, input, at, faults);
  }
}

void UncertainDocument::add_target(const json& value, const std::string& pointer,
                                   const InputPlace& place, std::size_t input,
                                   const std::string& at, FaultList& faults) {
  if (!value.is_number()) {
    faults.add(at, "leads to " + pointer + ", which is " + kind_of(value) +
                       ": only a number can be drawn");
    return;
  }
  if (pointer == "/resolution/seed" || pointer == "/resolution/particles_per_cell") {
    faults.add(at, "leads to " + pointer + ", which is not drawn: members have seeds of their own");
    return;
  }
  const json::json_pointer here(pointer);
  const auto set_by = std::ranges::find_if(targets_, [&](const Target& other) {
    return other.pointer == here && other.apply == Apply::set && place.apply == Apply::set;
  });
  if (set_by != targets_.end()) {
    faults.add(at, fmt::format("sets {}, which input {} sets already", pointer, set_by->input));
    return;
  }
  targets_.push_back({here, input, place.apply});
}

json UncertainDocument::with(const std::vector<double>& values) const {
  json document = document_;
  for (const Target& target : targets_) {
    json& number = document.at(target.pointer);
    const double drawn = values[target.input], given = number.get<double>();
    switch (target.apply) {
      case Apply::set:
        number = drawn;
        break;
      case Apply::scale:
        number = given * drawn;
        break;
      case Apply::add:
        number = given + drawn;
        break;
    }
  }
  return document;
}

std::optional<std::size_t> UncertainDocument::input_at(const std::string& pointer) const {
  for (const Target& target : targets_) {
    const std::string own = target.pointer.to_string();
    if (own == pointer || own.starts_with(pointer + "/")) return target.input;
  }
  return std::nullopt;
}

}  // namespace leda::server
