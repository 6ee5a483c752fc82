#pragma once
// Where runs are computed: the processes of this machine, or a cluster. The dispatcher knows
// nothing else about it, and executor_suite.cpp of the tests holds every executor to what is said
// here. Not safe for several threads.

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace leda::server {

/// One run: the folder holds case.json, and everything the run leaves goes there.
struct RunOrder {
  std::string run;
  std::filesystem::path folder;
};

/// What the leda program is called with to compute a run, after its own name. The last checkpoint
/// stays beside the result until the result was taken in.
std::vector<std::string> worker_arguments(const RunOrder& order);

/// A run that is over. Whether it left a result, its folder says.
struct RunEnd {
  enum class How {
    exited,      ///< by itself, with `exit_code`
    killed,      ///< by a signal, or the machine lost it
    over_limit,  ///< it reached the limit of memory or time
    cancelled    ///< as asked
  };
  std::string run;
  How how = How::exited;
  int exit_code = 0;
  std::string reason;  ///< for people; empty after exit code 0
};

/// Whether the worker has told of any progress in this folder.
bool has_begun(const std::filesystem::path& folder);

/// The end of a run whose time was over. A run that had not begun lost its time to the machine or
/// the cluster, so another try may do better: that one was killed. The others are over the limit.
RunEnd out_of_time(const std::string& run, bool begun);

class Executor {
 public:
  virtual ~Executor() = default;
  /// How many more runs it would take now.
  virtual std::size_t free_slots() const = 0;
  /// Takes a run. A failure to start it is told by poll().
  virtual void submit(const RunOrder& order) = 0;
  /// The runs that ended since the last call, each once. A run whose state cannot be learnt, for
  /// example because a cluster does not answer, has not ended.
  virtual std::vector<RunEnd> poll() = 0;
  /// Ends a run; poll() tells when it is over. Unknown runs are ignored.
  virtual void cancel(const std::string& run) = 0;

  /// Whether runs go on when their server ends.
  virtual bool outlives_server() const { return false; }
  /// Takes up a run that an earlier server submitted: poll() then tells its end. Comes before the
  /// first poll(), which gives up the runs that nobody adopted.
  /// @return false where the run is not computed any more
  virtual bool adopt([[maybe_unused]] const RunOrder& order) { return false; }
};

}  // namespace leda::server
