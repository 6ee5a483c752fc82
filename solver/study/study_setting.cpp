#include "solver/study/study_setting.hpp"

namespace leda::solver {

bool is_finer(const StudySetting& a, const StudySetting& b) {
  for (const StudyAxis& axis : study_axes) {
    const double of_a = axis.value(a), of_b = axis.value(b);
    if (of_a != of_b) return axis.finer == Finer::smaller ? of_a < of_b : of_a > of_b;
  }
  return false;
}

bool are_in_line(const StudySetting& a, const StudySetting& b, const StudyAxis& along) {
  StudySetting moved = b;
  along.set(moved, along.value(a));
  return moved == a;
}

}  // namespace leda::solver
