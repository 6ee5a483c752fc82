#pragma once
// The front door of the solver: a section and its settings in, a result out.

#include <functional>
#include <string>

#include "solver/section/frame.hpp"
#include "solver/section/run_settings.hpp"
#include "solver/section/section.hpp"
#include "solver/section/section_result.hpp"

namespace leda::solver {

struct Progress {
  double fraction = 0;  ///< of the most the run can take, 0 to 1
  double time_s = 0;    ///< since softening is on
  std::string stage;    ///< "initial stress", "undrained", "softening", "toe cut"
};

/// What a caller may want to hear while a run goes on. Empty members cost nothing.
struct Listener {
  std::function<void(const Progress&)> progress;
  std::function<void(const Frame&)> frame;  ///< first, every frame_interval_s, last
  std::function<bool()> interrupted;        ///< asked a few times a second; true ends the run
  /// Takes the state of a moving run every checkpoint_interval_s of the wall clock and when it
  /// is interrupted; `frames` is how many frames were handed over before it.
  std::function<void(const std::string& state, std::int64_t frames)> checkpoint;
  double checkpoint_interval_s = 30;
  /// A state that checkpoint got from the same case and program: the run goes on from there and
  /// gives the same result and the same later frames as one that was never interrupted.
  std::string resume_from;
  /// Told once, before the first frame, where resume_from is given: whether the run goes on from
  /// it. False: it is no state of this run, which starts anew.
  std::function<void(bool taken_up)> resumed;
};

/// Runs one section, with the same bytes every time, whatever the number of threads.
/// Failure of the run is a status of the result, never an exception.
/// @pre validate(section, settings) is empty; threads >= 1
SectionResult simulate(const Section& section, const RunSettings& settings,
                       const Listener& listener = {}, int threads = 1);

}  // namespace leda::solver
