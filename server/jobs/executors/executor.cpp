#include "server/jobs/executors/executor.hpp"

namespace leda::server {

std::vector<std::string> worker_arguments(const RunOrder& order) {
  return {"simulate",
          (order.folder / "case.json").string(),
          "--out",
          order.folder.string(),
          "--keep-checkpoint",
          "--no-progress"};
}

bool has_begun(const std::filesystem::path& folder) {
  std::error_code unknown;
  return std::filesystem::exists(folder / "progress.json", unknown);
}

RunEnd out_of_time(const std::string& run, bool begun) {
  if (begun) return {run, RunEnd::How::over_limit, 0, "the run took longer than it may"};
  return {run, RunEnd::How::killed, 0, "its time was over before the run had begun"};
}

}  // namespace leda::server
