#include "solver/statics/column_matrix.hpp"

#include <algorithm>
#include <utility>

namespace leda::solver {

namespace {

// A last column without unknowns where their number is odd.
std::vector<std::int32_t> even_columns(std::vector<std::int32_t> first) {
  if (first.size() % 2 == 0) first.push_back(first.back());
  return first;
}

std::vector<std::size_t> triangle_starts(const std::vector<std::int32_t>& first) {
  std::vector<std::size_t> start{0};
  for (std::size_t c = 0; c + 2 < first.size(); c += 2) {
    start.push_back(start.back() +
                    triangle_size(first[c + 1] - first[c], first[c + 2] - first[c + 1]));
  }
  return start;
}

// Unknowns of a pair's first column reach one column of the next pair, those of its second two.
std::vector<std::size_t> run_starts(const std::vector<std::int32_t>& first) {
  std::vector<std::size_t> start{0};
  for (std::size_t c = 0; c + 2 < first.size(); c += 2) {
    const auto runs = first[c + 1] - first[c] + 2 * (first[c + 2] - first[c + 1]);
    start.push_back(start.back() + static_cast<std::size_t>(runs));
  }
  return start;
}

}  // namespace

ColumnMatrix::ColumnMatrix(const Freedoms& freedoms)
    : first_(even_columns(freedoms.first)),
      column_of_(static_cast<std::size_t>(freedoms.count())),
      triangle_at_(triangle_starts(first_)),
      triangles_(triangle_at_.back(), 0.0F),
      runs_at_(run_starts(first_)),
      run_begin_(runs_at_.back()),
      runs_(runs_at_.back() * run, 0.0F) {
  for (std::size_t c = 0; c + 1 < first_.size(); ++c) {
    std::fill(column_of_.begin() + first_[c], column_of_.begin() + first_[c + 1],
              static_cast<std::int32_t>(c));
  }
  const auto& row = freedoms.row_of;
  const auto lowest_felt = [&](std::size_t column, std::int32_t u) {
    const auto from = row.begin() + first_[column], to = row.begin() + first_[column + 1];
    const auto at = std::lower_bound(from, to, row[static_cast<std::size_t>(u)] - 2);
    return static_cast<std::int32_t>(at - row.begin());
  };
  for (std::size_t pair = 0; pair + 1 < pairs(); ++pair) {
    for (std::int32_t u = begin(pair); u < middle(pair); ++u) {
      run_begin_[run_of(pair, u, 2)] = lowest_felt(2 * pair + 2, u);
    }
    for (std::int32_t u = middle(pair); u < end(pair); ++u) {
      run_begin_[run_of(pair, u, 1)] = lowest_felt(2 * pair + 2, u);
      run_begin_[run_of(pair, u, 2)] = lowest_felt(2 * pair + 3, u);
    }
  }
}

double ColumnMatrix::bytes(const Freedoms& freedoms) {
  const auto first = even_columns(freedoms.first);
  return static_cast<double>(triangle_starts(first).back()) * sizeof(float) +
         static_cast<double>(run_starts(first).back()) *
             (run * sizeof(float) + sizeof(std::int32_t));
}

Triangle ColumnMatrix::triangle(std::size_t pair) {
  return {triangles_.data() + triangle_at_[pair], middle(pair) - begin(pair),
          end(pair) - middle(pair)};
}

ConstTriangle ColumnMatrix::triangle(std::size_t pair) const {
  return {triangles_.data() + triangle_at_[pair], middle(pair) - begin(pair),
          end(pair) - middle(pair)};
}

std::size_t ColumnMatrix::run_of(std::size_t pair, std::int32_t unknown, std::size_t apart) const {
  const std::int32_t split = middle(pair);
  if (unknown < split) return runs_at_[pair] + static_cast<std::size_t>(unknown - begin(pair));
  const auto before = static_cast<std::size_t>(split - begin(pair));
  return runs_at_[pair] + before + 2 * static_cast<std::size_t>(unknown - split) + apart - 1;
}

Eigen::Map<const ColumnMatrix::Run> ColumnMatrix::run_values(std::size_t at) const {
  return Eigen::Map<const Run>(runs_.data() + at * run);
}

template <class Visit>
void ColumnMatrix::for_each_run(std::size_t pair, const Visit& visit) const {
  std::size_t at = runs_at_[pair];
  for (std::int32_t u = begin(pair); u < middle(pair); ++u) visit(u, at++);
  for (std::int32_t u = middle(pair); u < end(pair); ++u) {
    visit(u, at++);
    visit(u, at++);
  }
}

void ColumnMatrix::add(std::int32_t row, std::int32_t column, double value) {
  if (row < column) return;
  const auto r = static_cast<std::size_t>(column_of_[static_cast<std::size_t>(row)]);
  const auto c = static_cast<std::size_t>(column_of_[static_cast<std::size_t>(column)]);
  const std::size_t pair = c / 2;
  if (r / 2 == pair) {
    triangle(pair).at(row - begin(pair), column - begin(pair)) += static_cast<float>(value);
  } else {
    const std::size_t at = run_of(pair, column, r - c);
    runs_[at * run + static_cast<std::size_t>(row - run_begin_[at])] += static_cast<float>(value);
  }
}

// Subtracts B A^-1 B^T = W^T W from the next pair, with W = L^-1 B^T.
void ColumnMatrix::take_from_next(std::size_t pair) {
  const ConstTriangle own = std::as_const(*this).triangle(pair);
  const Index n1 = own.s().cols(), n2 = own.s().rows();
  const Index next = end(pair), next_n1 = middle(pair + 1) - next;
  Eigen::MatrixXf w = Eigen::MatrixXf::Zero(n1 + n2, end(pair + 1) - next);
  if (w.size() == 0) return;
  for_each_run(pair, [&](std::int32_t u, std::size_t at) {
    const Index from = run_begin_[at] - next, most = std::min<Index>(run, w.cols() - from);
    w.row(u - begin(pair)).segment(from, most) += run_values(at).head(most).transpose();
  });
  // Of W's upper part only the first column of the next pair has anything.
  auto upper = w.topLeftCorner(n1, next_n1);
  auto lower = w.bottomRows(n2);
  const auto t2 = own.t2_transposed().triangularView<Eigen::Upper>();
  own.t1().triangularView<Eigen::Lower>().solveInPlace(upper);
  lower.leftCols(next_n1).noalias() -= own.s() * upper;
  t2.transpose().solveInPlace(lower);
  Triangle other = triangle(pair + 1);
  const auto near = w.leftCols(next_n1);
  const auto far = lower.rightCols(w.cols() - next_n1);
  if (near.size() > 0) {
    other.t1().selfadjointView<Eigen::Lower>().rankUpdate(near.transpose(), -1.0F);
  }
  if (far.size() == 0) return;
  other.s().noalias() -= far.transpose() * lower.leftCols(next_n1);
  other.t2_transposed().selfadjointView<Eigen::Upper>().rankUpdate(far.transpose(), -1.0F);
}

bool ColumnMatrix::factorize() {
  for (std::size_t pair = 0; pair < pairs(); ++pair) {
    if (!leda::solver::factorize(triangle(pair))) return false;
    if (pair + 1 < pairs()) take_from_next(pair);
  }
  return true;
}

// With z_i = A_i^-1 (r_i - B_{i-1} z_{i-1}) from the left, x_i = z_i - A_i^-1 B_i^T x_{i+1} from
// the right; A_i are the factorized ones.
void ColumnMatrix::solve(Vector& solution) const {
  const Index count = solution.size();
  Eigen::VectorXf x = Eigen::VectorXf::Zero(count + run);  // runs may reach past the last unknown
  x.head(count) = solution.cast<float>();
  const auto part = [&](std::size_t pair) {
    return x.segment(begin(pair), end(pair) - begin(pair));
  };
  for (std::size_t pair = 0; pair < pairs(); ++pair) {
    leda::solver::solve(triangle(pair), part(pair));
    if (pair + 1 == pairs()) break;
    for_each_run(pair, [&](std::int32_t u, std::size_t at) {
      x.segment<run>(run_begin_[at]) -= x[u] * run_values(at);
    });
  }
  for (std::size_t pair = pairs() - 1; pair-- > 0;) {
    Eigen::VectorXf felt = Eigen::VectorXf::Zero(end(pair) - begin(pair));
    for_each_run(pair, [&](std::int32_t u, std::size_t at) {
      felt[u - begin(pair)] += run_values(at).dot(x.segment<run>(run_begin_[at]));
    });
    leda::solver::solve(triangle(pair), felt);
    part(pair) -= felt;
  }
  solution = x.head(count).cast<double>();
}

}  // namespace leda::solver
