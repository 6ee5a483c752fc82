#pragma once
// A real Slurm of one node on the loopback interface, brought up by deploy/slurm/one-node.sh.

#include <filesystem>
#include <memory>
#include <string>

#include "tests/server/temporary_folder.hpp"

namespace leda::tests {

class OneNodeSlurm {
 public:
  /// Why there can be none here; empty: there can.
  static std::string missing();
  /// The one of this program: started when it is first asked for, ended with the program. Its
  /// clients find it, because SLURM_CONF is set. @throws std::runtime_error
  static OneNodeSlurm& instance();

  ~OneNodeSlurm();
  OneNodeSlurm(const OneNodeSlurm&) = delete;
  OneNodeSlurm& operator=(const OneNodeSlurm&) = delete;

  /// Calls one-node.sh: "start", "stop" or "kill" of "controller" or "node".
  void call(const std::string& what, const std::string& daemon);
  /// Cores that Slurm gives away: those of this process, which may be fewer than the machine's.
  int cores() const;
  /// Ends all that is in the queue, and waits until it is empty.
  void clear();
  /// Lines of the file of completed jobs that contain a text.
  int completed(const std::string& text) const;
  std::filesystem::path completion_file() const { return folder_.path() / "log" / "jobcomp.txt"; }

 private:
  OneNodeSlurm();
  TemporaryFolder folder_;
};

}  // namespace leda::tests
