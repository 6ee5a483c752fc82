#include "tests/cluster/one_node_slurm.hpp"

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "server/jobs/executors/spawn.hpp"

namespace leda::tests {
namespace {

using namespace std::chrono_literals;

const std::string script = std::string(LEDA_SOURCE_DIR) + "/deploy/slurm/one-node.sh";

/// @return what the program printed
std::string run(const std::vector<std::string>& arguments) {
  const std::atomic<bool> never{false};
  const auto said = server::ask_program(arguments, 90s, never);
  if (said.ended && said.exit_code == 0) return said.out;
  std::string text;
  for (const auto& argument : arguments) text += argument + " ";
  throw std::runtime_error(text + "failed: " + said.errors);
}

}  // namespace

std::string OneNodeSlurm::missing() {
  if (geteuid() != 0) return "a Slurm of one node needs root";
  for (const char* program : {"/usr/sbin/munged", "/usr/sbin/slurmctld", "/usr/sbin/slurmd",
                              "/usr/bin/sbatch", "/usr/bin/squeue"}) {
    if (!std::filesystem::exists(program)) {
      return std::string(program) + " is not installed (packages slurm-wlm and munge)";
    }
  }
  return "";
}

OneNodeSlurm& OneNodeSlurm::instance() {
  static OneNodeSlurm only;
  return only;
}

OneNodeSlurm::OneNodeSlurm() {
  run({script, "up", folder_.path().string()});
  setenv("SLURM_CONF", (folder_.path() / "slurm.conf").c_str(), 1);
}

OneNodeSlurm::~OneNodeSlurm() {
  const std::atomic<bool> never{false};
  server::ask_program({script, "down", folder_.path().string()}, 90s, never);
}

void OneNodeSlurm::call(const std::string& what, const std::string& daemon) {
  run({script, what, daemon, folder_.path().string()});
}

int OneNodeSlurm::cores() const { return std::stoi(run({"sinfo", "-h", "-o", "%c"})); }

void OneNodeSlurm::clear() {
  const auto until = std::chrono::steady_clock::now() + 60s;
  while (!run({"squeue", "-h"}).empty()) {
    if (std::chrono::steady_clock::now() > until) throw std::runtime_error("the queue stays full");
    run({"scancel", "--user=root"});
    std::this_thread::sleep_for(200ms);
  }
}

int OneNodeSlurm::completed(const std::string& text) const {
  std::ifstream in(completion_file());
  int lines = 0;
  for (std::string line; std::getline(in, line);)
    lines += static_cast<int>(line.find(text) != std::string::npos);
  return lines;
}

}  // namespace leda::tests
