#pragma once
// What goes wrong while a server works, in an order that a seed decides.

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <random>
#include <string>

#include "tests/service/full_disk.hpp"
#include "tests/service/leda_process.hpp"

namespace leda::tests {

struct Disturbances {
  int server_kills = 0, worker_kills = 0;
  int full_disks = 0, corrupt_results = 0, held_stores = 0;
  int kills() const { return server_kills + worker_kills; }
};

class Disturber {
 public:
  using Start = std::function<std::unique_ptr<LedaServer>()>;

  /// @param start starts a server on the disk's folder
  Disturber(SmallDisk& disk, Start start, unsigned seed)
      : disk_(disk), start_(std::move(start)), random_(seed) {
    restart();
  }

  LedaServer& server() { return *server_; }
  const Disturbances& done() const { return done_; }

  void kill_server();
  /// One of them, with SIGKILL. A section is not made to fail three times in the life of one
  /// server: that would be its end, as it should be.
  void kill_worker();
  /// Leaves no space for a while, then frees it.
  void fill_disk();
  /// Damages what a worker left before the server looks at it.
  void corrupt_result();
  /// Another program holds the store for longer than the server waits for it.
  void hold_store();

  /// Kills a server or a worker, whichever comes.
  void kill_any();
  /// A pause between two disturbances.
  void wait();

 private:
  int number(int least, int most) { return std::uniform_int_distribution(least, most)(random_); }
  void restart();
  bool may_fail(const std::string& section);
  static std::string section_of(pid_t worker);

  SmallDisk& disk_;
  Start start_;
  std::mt19937 random_;
  std::unique_ptr<LedaServer> server_;
  std::map<std::string, int> failures_;  ///< of sections, in the life of this server
  Disturbances done_;
};

}  // namespace leda::tests
