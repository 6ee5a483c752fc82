#include "server/jobs/request_pointers.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

namespace leda::server {
namespace {

using nlohmann::json;

struct Split {
  std::string list;       ///< "lines"
  std::size_t index = 0;  ///< 0
  std::string rest;       ///< "/line/1"
};

/// "/lines/0/line/1" or, without a list, "/0/layers".
Split split(std::string_view pointer, bool with_list) {
  Split parts;
  const auto take = [&pointer] {
    if (pointer.starts_with('/')) pointer.remove_prefix(1);
    const auto end = std::min(pointer.find('/'), pointer.size());
    const auto segment = pointer.substr(0, end);
    pointer.remove_prefix(end);
    return segment;
  };
  if (with_list) parts.list = take();
  const auto index = take();
  std::from_chars(index.data(), index.data() + index.size(), parts.index);
  parts.rest = pointer;
  return parts;
}

json input(const json& request, const char* name) {
  const auto at = json::json_pointer(std::string("/inputs/") + name);
  return request.contains(at) ? request[at] : json();
}

}  // namespace

std::string layout_pointer(const json& request, const std::string& pointer) {
  std::string all = "/inputs/sections";
  if (pointer.empty()) return all;
  const Split parts = split(pointer, true);
  const json sections = input(request, "sections");
  if (!sections.is_array()) return all + parts.rest;
  const char* key = parts.list == "along" ? "along" : "line";
  std::size_t seen = 0;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    if (!sections[i].contains(key) || seen++ != parts.index) continue;
    return all + "/" + std::to_string(i) + parts.rest;
  }
  return all;
}

std::string soil_pointer(const json& request, const std::string& pointer) {
  std::string all = "/inputs/soil";
  if (pointer.empty()) return all;
  const Split parts = split(pointer, false);
  const bool several = input(request, "soil").contains("models");
  return several ? all + "/models/" + std::to_string(parts.index) + parts.rest : all + parts.rest;
}

std::string case_pointer(const json& request, const std::string& pointer, std::size_t model) {
  constexpr std::array<std::string_view, 6> of_the_request{
      "/resolution", "/trigger", "/damping", "/stop", "/output", "/time_step_factor"};
  for (const auto prefix : of_the_request) {
    if (pointer.starts_with(prefix)) return "/inputs" + pointer;
  }
  for (const std::string_view prefix : {"/ground", "/crest", "/toe", "/name"}) {
    if (pointer.starts_with(prefix)) return "/inputs/sections";
  }
  return soil_pointer(request, "/" + std::to_string(model) + pointer);
}

std::vector<Fault> faults_of(const profiles::BuiltSection& built, const RunSettings& settings,
                             const json& request) {
  std::vector<Fault> faults = built.faults;
  for (Fault& fault : faults) fault.pointer = soil_pointer(request, fault.pointer);
  if (!faults.empty()) return faults;
  faults = validate(built.section, settings);
  for (Fault& fault : faults) {
    const auto origin = profiles::origin_of(built, fault.pointer);
    fault.pointer = case_pointer(request, origin.pointer, origin.model);
  }
  return faults;
}

}  // namespace leda::server
