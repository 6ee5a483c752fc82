#pragma once
// From particles to what an engineer reads: surface, backscarp, front, slides.

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "solver/run/model_of_run.hpp"
#include "solver/run/seed_particles.hpp"
#include "solver/section/crest_and_toe.hpp"
#include "solver/section/frame.hpp"
#include "solver/section/section.hpp"

namespace leda::solver {

/// Elevation of the top particle (plus half its size) of each column of cells; the base where
/// a column is empty. Section coordinates.
struct Surface {
  double first_x = 0;  ///< left edge of the first column, m
  double cell = 0;
  std::vector<double> z;

  double left(std::size_t i) const { return first_x + cell * static_cast<double>(i); }
  double middle(std::size_t i) const { return left(i) + 0.5 * cell; }
};

Surface surface(const AnyModel& model, const Seeded& seeded);

/// A surface at the base everywhere.
Surface empty_surface(const Seeded& seeded);

/// Column of a surface at x, the nearest where there is none.
std::size_t column_of(const Surface& s, double x);

/// Thresholds of the definitions in solver/README.md, "Retrogression and runout".
inline constexpr double surface_threshold_m = 0.5;
inline constexpr std::size_t most_gap_columns = 2;

struct Movement {
  double retrogression_m = 0;
  double runout_m = 0;
  Point backscarp;
  Point front;
  bool far_side_dropped = false;  ///< ground beyond the toe, of another bank, went down

  bool moved() const { return retrogression_m > 0 || runout_m > 0 || far_side_dropped; }
};

/// Retrogression and runout of the present state against the surface at the start.
Movement measure(const AnyModel& model, const Seeded& seeded, const Section& section,
                 const CrestAndToe& bank, const Surface& before);

/// How far the backscarp lies behind the crest, m; zero where nothing has dropped.
double retrogression(const Surface& before, const Surface& now, const CrestAndToe& bank);

/// Counts slides while the run goes on. Lengths are measured in the height H of the bank, times in
/// sqrt(H / g). A scarp that crumbles retreats no faster than its debris leaves, and that is slower
/// than sqrt(g H), the speed of a shallow wave and of a body that fell by H / 2. Faster than that
/// the backscarp can only go where ground over some width lets go at once, as one slide: it begins
/// when the backscarp retreats by H / 4 (and three cells, since it jumps by single ones while
/// crumbling) within sqrt(H / g) / 4, and is over when it retreats by less than half as much.
class SlideCount {
 public:
  SlideCount() = default;  ///< counts nothing
  /// @param bank_height_m from toe to crest, > 0
  SlideCount(double bank_height_m, double cell_m);

  /// @param time_s never decreasing; looks at most look_interval_s() apart
  void observe(double time_s, double retrogression_m);
  int count() const { return count_; }
  double look_interval_s() const { return std::min(0.1, window_s_ / 3); }

  /// Calls visit(name, value) for every part of its state.
  template <class Self, class Visit>
  static void each(Self& self, Visit&& visit) {
    visit("recent", self.recent_);
    visit("recent_count", self.recent_count_);
    visit("window_s", self.window_s_);
    visit("begins_m", self.begins_m_);
    visit("sliding", self.sliding_);
    visit("count", self.count_);
  }

 private:
  void forget_oldest();

  static constexpr std::size_t most_recent = 32;
  std::array<std::array<double, 2>, most_recent> recent_{};  ///< time, retrogression
  std::size_t recent_count_ = 0;
  double window_s_ = 1, begins_m_ = std::numeric_limits<double>::infinity();
  bool sliding_ = false;
  int count_ = 0;
};

/// The points as they are, in the order of their seeding. Points cut away are absent.
/// @pre the last step kept the motion
Frame frame(const AnyModel& model, const Seeded& seeded, double time_s);

}  // namespace leda::solver
