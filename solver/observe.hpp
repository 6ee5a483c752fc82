#pragma once
// From particles to what an engineer reads: surface, backscarp, front, slides.

#include <array>
#include <vector>

#include "solver/section/crest_and_toe.hpp"
#include "solver/section/frame.hpp"
#include "solver/section/section.hpp"
#include "solver/seed_particles.hpp"

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

Surface surface(const Seeded& seeded);

/// Thresholds of the definitions in solver/README.md, "Retrogression and runout".
inline constexpr double surface_threshold_m = 0.5;
inline constexpr std::size_t most_gap_columns = 2;
inline constexpr double slide_window_s = 0.3;
inline constexpr double slide_begins_m = 4.0;
inline constexpr double slide_ends_m = 2.0;

struct Movement {
  double retrogression_m = 0;
  double runout_m = 0;
  Point backscarp;
  Point front;
  bool far_side_dropped = false;  ///< ground beyond the toe, of another bank, went down
};

/// Retrogression and runout of the present state against the surface at the start.
Movement measure(const Seeded& seeded, const Section& section, const CrestAndToe& bank,
                 const Surface& before);

/// Counts slides while the run goes on. Between slides the backscarp creeps back by crumbling; a
/// slide is a burst: it begins when the backscarp retreats by slide_begins_m within
/// slide_window_s and is over when it retreats by less than slide_ends_m in that time.
class SlideCount {
 public:
  /// @param time_s never decreasing
  void observe(double time_s, double retrogression_m);
  int count() const { return count_; }

 private:
  void forget_oldest();

  static constexpr std::size_t most_recent = 16;
  std::array<std::array<double, 2>, most_recent> recent_{};  ///< time, retrogression
  std::size_t recent_count_ = 0;
  bool sliding_ = false;
  int count_ = 0;
};

/// The particles as they are, in the order of their seeding. Particles cut away are absent.
Frame frame(const Seeded& seeded, const LawTable& laws, double time_s);

}  // namespace leda::solver
