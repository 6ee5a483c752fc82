// leda screen: what can be known of a section, or of a site, before a simulation.

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "server/commands/commands.hpp"
#include "server/commands/exit_code.hpp"
#include "server/documents/case_file.hpp"
#include "server/documents/screening_document.hpp"
#include "server/documents/warning_lines.hpp"
#include "solver/screening/site_material.hpp"
#include "solver/section/warnings.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

constexpr std::streamsize largest_file_bytes = 16 << 20;

constexpr const char* examples = R"(
A case is a section with its layers and materials, as for leda simulate. A site is one bank of one
clay: height_m, unit_weight_kN_m3, peak_strength_kPa, and what is known of slope_angle_deg,
remolded_strength_kPa, peak_strain, softening {alpha, beta, residual_strain},
plasticity_index_percent, liquidity_index, preconsolidation_kPa (strains as fractions). What an
input is missing for is null, and "reasons" says why.

Examples:
  leda screen case.json
  leda screen --site site.json
  leda screen --site site.json --json | jq .remolding_energy_by)";

struct ScreenOptions {
  std::string case_file;
  std::string site_file;
  bool as_json = false;
};

/// The whole file; what is wrong with it is told on standard error.
std::optional<std::string> read_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string text(static_cast<std::size_t>(largest_file_bytes) + 1, '\0');
  in.read(text.data(), largest_file_bytes + 1);
  if (in.bad() || (!in.eof() && in.gcount() == 0)) {
    fmt::print(stderr, "{}: cannot be read\n", path);
    return std::nullopt;
  }
  if (in.gcount() > largest_file_bytes) {
    fmt::print(stderr, "{}: larger than 16 MiB\n", path);
    return std::nullopt;
  }
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

void print_faults(const std::string& path, const std::vector<Fault>& faults) {
  for (const Fault& fault : faults) {
    fmt::print(stderr, "{}: {}: {}\n", path, fault.pointer.empty() ? "/" : fault.pointer,
               fault.message);
  }
}

struct Screened {
  solver::ScreeningResult result;
  std::vector<std::string> warnings;
};

std::optional<Screened> screen_case_file(const std::string& path) {
  const auto text = read_file(path);
  if (!text) return std::nullopt;
  const auto parsed = parse_case_file(*text);
  print_faults(path, parsed.faults);
  if (!parsed) return std::nullopt;
  const Section& section = parsed.value->section;
  const RunSettings& settings = parsed.value->settings;
  return Screened{solver::screen(section, settings), warnings_of(section, settings)};
}

std::optional<Screened> screen_site_file(const std::string& path) {
  const auto text = read_file(path);
  if (!text) return std::nullopt;
  const auto parsed = parse_site_file(*text);
  print_faults(path, parsed.faults);
  if (!parsed) return std::nullopt;
  return Screened{solver::screen_site(*parsed.value), solver::warnings_of(*parsed.value)};
}

/// "bishop 1.23, spencer -, ..." of one object of the answer.
std::string numbers_of(const json& object) {
  std::string text;
  for (const auto& [key, value] : object.items()) {
    if (!text.empty()) text += ", ";
    text += key + " ";
    if (value.is_number())
      text += fmt::format("{:.4g}", value.get<double>());
    else
      text += value.is_null() ? "-" : value.dump();
  }
  return text;
}

void print_readable(const json& document) {
  for (const char* key : {"stability_number", "sensitivity", "brittleness_index", "peak_strain",
                          "limit_state_energy_kJ_m3", "potential_energy_kJ_m3",
                          "remolding_energy_kJ_m3", "destruction_index"}) {
    const json& value = document.at(key);
    fmt::print("{:<28}{}\n", key,
               value.is_null() ? std::string("-") : fmt::format("{:.4g}", value.get<double>()));
  }
  fmt::print("remolding_energy_by         {}\n", numbers_of(document.at("remolding_energy_by")));
  fmt::print("empirical_retrogression_m   {}\n",
             numbers_of(document.at("empirical_retrogression_m")));
  for (const auto& [which, factors] : document.at("factor_of_safety").items()) {
    fmt::print("factor of safety, {:<18}{}\n", which, numbers_of(factors));
  }
  for (const json& c : document.at("criteria")) {
    const json& met = c.at("met");
    fmt::print("{:<40}{:<8}{}\n", c.at("name").get<std::string>(),
               met.is_null()     ? "unknown"
               : met.get<bool>() ? "met"
                                 : "not met",
               c.at("why").get<std::string>());
  }
  fmt::print("decision: {}\n", document.at("decision").get<std::string>());
  for (const json& reason : document.at("reasons")) {
    fmt::print("  {}\n", reason.get<std::string>());
  }
}

int run(const ScreenOptions& options) {
  if (options.case_file.empty() == options.site_file.empty()) {
    fmt::print(stderr, "leda screen: give a case file or --site SITE.json, one of the two\n");
    return 2;
  }
  const auto screened = options.site_file.empty() ? screen_case_file(options.case_file)
                                                  : screen_site_file(options.site_file);
  if (!screened) return 2;
  fmt::print(stderr, "{}", warning_lines(screened->warnings));
  json document = to_document(screened->result);
  document["warnings"] = screened->warnings;
  if (options.as_json || isatty(STDOUT_FILENO) == 0)
    fmt::print("{}\n", document.dump(2));
  else
    print_readable(document);
  return 0;
}

}  // namespace

void add_screen(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("screen", "what is known of a section before a simulation");
  auto options = std::make_shared<ScreenOptions>();
  command->add_option("case", options->case_file, "case file, JSON");
  command->add_option("--site", options->site_file, "site file, JSON, instead of a case");
  command->add_flag("--json", options->as_json,
                    "JSON on a terminal too; into a pipe or file it always is");
  command->footer(examples);
  command->callback([options, &exit_code] { exit_code = guarded([&] { return run(*options); }); });
}

}  // namespace leda::server
