#include "tests/server/run_fixture.hpp"

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "db/result_file.hpp"
#include "server/documents/case_file.hpp"
#include "server/documents/result_document.hpp"

namespace leda::tests {

std::string small_case() {
  return R"({
    "name": "small", "ground": [[0, 10], [40, 10], [60, 2], [90, 2]], "base_m": 0,
    "layers": [{"material": "clay"}],
    "materials": {"clay": {"unit_weight_kN_m3": 17, "shear_modulus_kPa": 2000,
                           "poisson_ratio": 0.4, "peak_strength_kPa": 60}},
    "trigger": {"kind": "undrained"}, "resolution": {"cell_m": 2, "particles_per_cell": 4},
    "stop": {"max_time_s": 2}})";
}

std::string simulate_request() { return R"({"inputs": {"case": )" + small_case() + "}}"; }

SectionResult result_of_case_in(const std::filesystem::path& folder) {
  SectionResult result;
  result.status = RunStatus::at_rest;
  result.crest_to_crest_retrogression_m = 12.5;
  result.runout_m = 3.5;
  result.crest = {40, 10};
  result.toe = {60, 2};
  result.backscarp = {27.5, 10};
  result.front = {63.5, 2};
  result.trigger_used = "undrained";
  result.slides = 1;
  result.particles = 100;
  result.steps = 10;
  result.profile_after = {{0, 10}, {27.5, 10}, {63.5, 2}, {90, 2}};
  result.version = "test";
  const auto parsed = server::parse_case_file(read_text(folder / "case.json"));
  result.case_sha256 = server::case_sha256(parsed.value.value());
  return result;
}

SectionResult made_up_result() {
  SectionResult result;
  result.status = RunStatus::at_rest;
  result.run_time_s = 10;
  result.ns_per_particle_step = 45;
  return result;
}

void leave_result(const std::filesystem::path& folder, const SectionResult& result) {
  db::ResultFileWriter fields(folder / "fields.h5", {"clay"}, result.case_sha256, result.version);
  fields.close();
  write_text(folder / "result.json", server::result_text(result));
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

std::string read_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

}  // namespace leda::tests
