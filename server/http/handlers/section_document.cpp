#include "server/http/handlers/section_document.hpp"

#include <algorithm>
#include <fstream>

#include "server/documents/points.hpp"
#include "server/documents/result_document.hpp"
#include "server/layers/summary.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

constexpr std::streamoff most_log_bytes = 16'384;

}  // namespace

std::string end_of_log(const std::filesystem::path& file, std::streamoff most_bytes) {
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  if (!in) return "";
  const std::streamoff size = in.tellg();
  in.seekg(std::max<std::streamoff>(size - most_bytes, 0));
  std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (size > most_bytes) text.erase(0, std::min(text.find('\n'), text.size() - 1) + 1);
  return text;
}

json section_row(const db::SectionRecord& section) {
  json row = {{"name", section.name},
              {"line", section.line < 0 ? json() : json(section.line)},
              {"order_m", section.line < 0 ? json() : json(section.order)},
              {"state", db::to_string(section.state)},
              {"status", status_of(section)},
              {"reason", section.reason},
              {"run", section.run},
              {"attempts", section.attempts},
              {"crest_to_crest_retrogression_m", nullptr},
              {"runout_m", nullptr},
              {"runout_from_crest_m", nullptr},
              {"retrogression_is", nullptr},
              {"runout_is", nullptr},
              {"slides", nullptr},
              {"simulated_s", nullptr},
              {"run_time_s", nullptr},
              {"particles", nullptr},
              {"ns_per_particle_step", nullptr},
              {"case_sha256", nullptr},
              {"version", nullptr},
              {"engine", nullptr}};
  if (section.result) {
    const SectionResult& result = *section.result;
    row["crest_to_crest_retrogression_m"] = result.crest_to_crest_retrogression_m;
    row["runout_m"] = result.runout_m;
    row["runout_from_crest_m"] = result.runout_from_crest_m;
    row["retrogression_is"] = to_string(result.retrogression_is);
    row["runout_is"] = to_string(result.runout_is);
    row["slides"] = result.slides;
    row["simulated_s"] = result.simulated_s;
    row["run_time_s"] = result.run_time_s;
    row["particles"] = result.particles;
    row["ns_per_particle_step"] = result.ns_per_particle_step;
    row["case_sha256"] = result.case_sha256;
    row["version"] = result.version;
    if (result.engine) row["engine"] = to_document(*result.engine);
  }
  row["warnings"] = warnings_of(section);
  return row;
}

json section_detail(const db::SectionRecord& section, const DataFolder& data) {
  json document = section_row(section);
  document["trace"] = points(section.trace);
  document["profile_before"] = points(section.ground);
  document["profile_after"] = section.result ? points(section.result->profile_after) : json();
  const bool has_bank = !section.ground.empty();
  document["crest_m"] = has_bank ? json{section.crest.x, section.crest.z} : json();
  document["toe_m"] = has_bank ? json{section.toe.x, section.toe.z} : json();
  document["screening"] =
      section.screening.empty() ? json() : json::parse(section.screening, nullptr, false);
  document["result"] = section.result ? to_document(*section.result) : json();
  document["log"] =
      section.run.empty()
          ? ""
          : data.without_root(end_of_log(data.run(section.run) / "log.txt", most_log_bytes));
  return document;
}

}  // namespace leda::server
