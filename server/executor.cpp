#include "server/executor.hpp"

namespace leda::server {

std::vector<std::string> worker_arguments(const RunOrder& order) {
  return {"simulate", (order.folder / "case.json").string(), "--out", order.folder.string(),
          "--keep-checkpoint"};
}

}  // namespace leda::server
