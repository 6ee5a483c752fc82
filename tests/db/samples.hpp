#pragma once
// A scratch folder and made-up rows for the tests of the store.

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "db/store.hpp"

namespace leda::db::samples {

/// A folder of its own for each test, removed afterwards.
class ScratchFolder {
 public:
  ScratchFolder()
      : path_(std::filesystem::temp_directory_path() /
              ("leda-db-" + std::to_string(::getpid()) + "-" + std::to_string(count_++))) {
    std::filesystem::create_directories(path_);
  }
  ~ScratchFolder() { std::filesystem::remove_all(path_); }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  static inline std::atomic<int> count_ = 0;
  std::filesystem::path path_;
};

/// "S12": a word and a number.
inline std::string numbered(std::string word, int number) {
  word += std::to_string(number);
  return word;
}

inline RasterRecord raster(const std::string& id = "dem-0123456789ab") {
  return {.id = id,
          .name = "valley",
          .file = "rasters/" + id + ".tif",
          .sha256 = std::string(64, 'a'),
          .epsg = 2950,
          .cell_x = 1,
          .cell_y = 1.5,
          .width = 640,
          .height = 480,
          .box = {1000.25, 2000.5, 1640.25, 2480.5},
          .vertical_unit = "m",
          .created = "2026-01-31T12:00:00.000Z",
          .lowest_m = 3.25,
          .highest_m = 51,
          .share_without_data = 0.125,
          .cell_ground_x_m = 0.9999,
          .cell_ground_y_m = 1.4999,
          .undeclared_fill_m = 0,
          .warnings = {"a piece of zeros"}};
}

inline JobRecord job(const std::string& id = "job-1") {
  JobRecord job;
  job.id = id;
  job.process = "map-region";
  job.name = "sainte-monique";
  job.request = R"({"inputs": {}})";
  return job;
}

inline SectionRecord section(const std::string& name, int ordinal) {
  SectionRecord section;
  section.ordinal = ordinal;
  section.name = name;
  section.line = 0;
  section.order = 50.0 * ordinal;
  section.trace = {{300000.125, 5100000.1}, {300100.3, 5100050.7}};
  section.ground = {{0, 21.7}, {183, 21.7}, {220, 5.0}, {306, 1.0 / 3.0}};
  section.crest = {183, 21.7};
  section.toe = {220, 5.0};
  section.screening = R"({"decision": "simulate"})";
  section.warnings = {"shortened at nodata"};
  return section;
}

inline std::vector<SectionRecord> layout(int count) {
  std::vector<SectionRecord> all;
  all.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) all.push_back(section(numbered("S", i + 1), i));
  return all;
}

inline SectionResult result(RunStatus status = RunStatus::at_rest) {
  SectionResult r;
  r.status = status;
  r.crest_to_crest_retrogression_m = 103.2;
  r.runout_m = 52.4;
  r.runout_from_crest_m = 89.4;
  r.runout_is = Bound::lower_bound;
  r.crest = {183, 21.7};
  r.toe = {220, 5.0};
  r.backscarp = {79.8, 21.7};
  r.front = {272.4, 8.1};
  r.trigger_used = "undrained";
  r.slides = 6;
  r.rate_from_s = 2.5;
  r.simulated_s = 61;
  r.run_time_s = 40.2;
  r.steps = 24'000'000'000;
  r.particles = 41000;
  r.ns_per_particle_step = 58.5;
  r.balances = {0, 1e-12, 0.004};
  r.numerical_dissipation = 0.03;
  r.profile_after = {{0, 21.7}, {79.8, 0.1 + 0.2}};
  r.warnings = {"the front is within two cells of the edge"};
  r.case_sha256 = std::string(64, 'c');
  r.version = "0.1.0";
  r.engine = {Precision::single_precision, "avx2", 0.65, false};
  return r;
}

inline PlacedResult placed(const SectionRecord& section) {
  PlacedResult p;
  p.section = section.name;
  p.line = section.line;
  p.order = section.order;
  p.known = true;
  p.moved = true;
  p.backscarp = {300010.5, 5100001.25};
  p.crest = {300050, 5100020};
  p.toe = {300060, 5100030};
  p.front = {300090, 5100040};
  p.retrogression_m = 103.2;
  p.runout_m = 52.4;
  p.runout_is = Bound::lower_bound;
  p.warnings = {"placed"};
  p.made_by = std::string(64, 'd');
  return p;
}

}  // namespace leda::db::samples
