#include "server/commands/element_case.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>

#include "server/documents/case_file.hpp"
#include "server/documents/warning_lines.hpp"
#include "solver/section/warnings.hpp"

namespace leda::server {
namespace {

constexpr std::uintmax_t largest_case_bytes = 16 << 20;

std::optional<std::string> read_text_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return {};
  std::string text;
  for (std::istreambuf_iterator<char> c(in), end; c != end && text.size() <= largest_case_bytes;
       ++c) {
    text += *c;
  }
  return text;
}

std::string names_of(const Section& section) {
  std::string names;
  for (const auto& [name, material] : section.materials)
    names += (names.empty() ? "" : ", ") + name;
  return names;
}

/// The strength at the depth or elevation asked for, or what is missing to say it.
std::optional<double> peak_at(const Strength& strength, const ElementOptions& options,
                              std::vector<std::string>& faults) {
  const bool by_depth = strength.by == Strength::By::depth;
  const bool by_elevation = strength.by == Strength::By::elevation;
  if (options.depth_m && !by_depth) {
    faults.emplace_back("--depth: the peak strength of the material does not vary with depth");
  }
  if (options.elevation_m && !by_elevation) {
    faults.emplace_back(
        "--elevation: the peak strength of the material does not vary with elevation");
  }
  if (by_depth && !options.depth_m) {
    faults.emplace_back("--depth is missing: the peak strength varies with depth below ground");
  }
  if (by_elevation && !options.elevation_m) {
    faults.emplace_back("--elevation is missing: the peak strength varies with elevation");
  }
  if (!faults.empty()) return {};
  return strength.at(options.depth_m.value_or(0), options.elevation_m.value_or(0));
}

}  // namespace

void add_element_options(CLI::App& command, ElementOptions& options, bool cell_is_required) {
  command.add_option("case", options.case_file, "case file, JSON")->required();
  command.add_option("--material", options.material, "name of a material of the case")->required();
  auto* cell = command.add_option("--cell", options.cell_m, "size of the cell, m")
                   ->check(CLI::Range(1e-4, 100.0));
  if (cell_is_required) cell->required();
  command.add_option("--depth", options.depth_m,
                     "depth below ground, m, where the strength varies with depth");
  command.add_option("--elevation", options.elevation_m,
                     "elevation, m, where the strength varies with elevation");
}

std::optional<ElementCase> read_element_case(const ElementOptions& options) {
  const auto text = read_text_file(options.case_file);
  if (!text || text->size() > largest_case_bytes) {
    fmt::print(stderr, "{}: {}\n", options.case_file,
               text ? "larger than 16 MiB: not a case file" : "cannot be read");
    return {};
  }
  const auto parsed = parse_case_file(*text);
  if (!parsed) {
    for (const Fault& fault : parsed.faults) {
      fmt::print(stderr, "{}: {}: {}\n", options.case_file,
                 fault.pointer.empty() ? "/" : fault.pointer, fault.message);
    }
    return {};
  }
  const Section& section = parsed.value->section;
  const auto found = section.materials.find(options.material);
  if (found == section.materials.end()) {
    fmt::print(stderr, "--material: the case has no \"{}\"; it has {}\n", options.material,
               names_of(section));
    return {};
  }
  std::vector<std::string> faults;
  const auto peak = peak_at(found->second.peak_strength, options, faults);
  for (const auto& fault : faults) fmt::print(stderr, "{}\n", fault);
  if (!peak) return {};
  const auto warnings = warnings_of({*found});
  fmt::print(stderr, "{}", warning_lines(warnings));
  return ElementCase{found->first, found->second, *peak, parsed.value->settings.resolution.cell_m,
                     warnings};
}

void print_faults(const std::string& command, const std::vector<std::string>& faults) {
  for (const auto& fault : faults) fmt::print(stderr, "leda {}: {}\n", command, fault);
}

bool write_text(const std::string& path, const std::string& text) {
  if (path.empty() || path == "-") {
    std::cout << text << std::flush;
    return static_cast<bool>(std::cout);
  }
  std::ofstream out(path, std::ios::binary);
  out << text << std::flush;
  if (!out) fmt::print(stderr, "{}: cannot be written\n", path);
  return static_cast<bool>(out);
}

}  // namespace leda::server
