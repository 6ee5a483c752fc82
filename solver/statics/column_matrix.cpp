#include "solver/statics/column_matrix.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

namespace leda::solver {

namespace {
constexpr std::size_t reach = 2;  // columns

std::vector<std::size_t> block_starts(const std::vector<std::int32_t>& first) {
  const std::size_t columns = first.size() - 1;
  std::vector<std::size_t> start(columns * (reach + 1) + 1, 0);
  const auto size = [&](std::size_t c) {
    return c < columns ? static_cast<std::size_t>(first[c + 1] - first[c]) : std::size_t{0};
  };
  std::size_t next = 0;
  for (std::size_t c = 0; c < columns; ++c) {
    for (std::size_t below = 0; below <= reach; ++below) {
      start[c * (reach + 1) + below] = next;
      next += size(c) * size(c + below);
    }
  }
  start.back() = next;
  return start;
}
}  // namespace

ColumnMatrix::ColumnMatrix(const std::vector<std::int32_t>& first)
    : first_(first), start_(block_starts(first)) {
  value_.assign(start_.back(), 0.0F);
  column_of_.resize(static_cast<std::size_t>(first_.back()));
  for (std::size_t c = 0; c < columns(); ++c) {
    std::fill(column_of_.begin() + first_[c], column_of_.begin() + first_[c + 1],
              static_cast<std::int32_t>(c));
  }
}

double ColumnMatrix::bytes(const std::vector<std::int32_t>& first) {
  return static_cast<double>(block_starts(first).back()) * sizeof(float);
}

ColumnMatrix::Block ColumnMatrix::block(std::size_t row, std::size_t column) {
  return {&value_[start_[column * (reach + 1) + row - column]], size(row), size(column)};
}

ColumnMatrix::ConstBlock ColumnMatrix::block(std::size_t row, std::size_t column) const {
  return {&value_[start_[column * (reach + 1) + row - column]], size(row), size(column)};
}

void ColumnMatrix::add(std::int32_t row, std::int32_t column, double value) {
  if (row < column) return;
  const auto r = static_cast<std::size_t>(column_of_[static_cast<std::size_t>(row)]);
  const auto c = static_cast<std::size_t>(column_of_[static_cast<std::size_t>(column)]);
  const auto at = static_cast<std::size_t>((column - first_[c]) * size(r) + (row - first_[r]));
  value_[start_[c * (reach + 1) + r - c] + at] += static_cast<float>(value);
}

bool ColumnMatrix::factorize() {
  for (std::size_t c = 0; c < columns(); ++c) {
    if (size(c) == 0) continue;
    Eigen::Ref<Eigen::MatrixXf> diagonal = block(c, c);
    Eigen::LLT<Eigen::Ref<Eigen::MatrixXf>> llt(diagonal);
    if (llt.info() != Eigen::Success) return false;
    const std::size_t last = std::min(c + reach, columns() - 1);
    for (std::size_t r = c + 1; r <= last; ++r) {
      Block below = block(r, c);
      llt.matrixL().transpose().solveInPlace<Eigen::OnTheRight>(below);
      block(r, r).selfadjointView<Eigen::Lower>().rankUpdate(below, -1.0F);
      for (std::size_t m = c + 1; m < r; ++m) {
        block(r, m).noalias() -= below * block(m, c).transpose();
      }
    }
  }
  return true;
}

void ColumnMatrix::solve(Vector& solution) const {
  Eigen::VectorXf x = solution.cast<float>();
  const auto part = [&](std::size_t c) { return x.segment(first_[c], size(c)); };
  for (std::size_t c = 0; c < columns(); ++c) {
    for (std::size_t m = c > reach ? c - reach : 0; m < c; ++m) {
      part(c).noalias() -= block(c, m) * part(m);
    }
    auto own = part(c);
    block(c, c).triangularView<Eigen::Lower>().solveInPlace(own);
  }
  for (std::size_t c = columns(); c-- > 0;) {
    for (std::size_t r = c + 1; r <= std::min(c + reach, columns() - 1); ++r) {
      part(c).noalias() -= block(r, c).transpose() * part(r);
    }
    auto own = part(c);
    block(c, c).transpose().triangularView<Eigen::Upper>().solveInPlace(own);
  }
  solution = x.cast<double>();
}

}  // namespace leda::solver
