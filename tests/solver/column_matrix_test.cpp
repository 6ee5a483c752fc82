// The factor of the static solves against a dense one in double precision.
#include "solver/statics/column_matrix.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>

namespace leda::solver::test {
namespace {

/// Columns of nodes from row 2 on, of these heights; every node moves along both axes, but those of
/// the first and the last column upwards only.
struct Nodes {
  std::vector<std::int32_t> height;
  Freedoms freedoms;
  std::vector<std::vector<std::vector<std::int32_t>>> unknowns;  // [column][row - 2]

  explicit Nodes(std::vector<std::int32_t> heights) : height(std::move(heights)) {
    std::int32_t next = 0;
    for (std::size_t c = 0; c < height.size(); ++c) {
      freedoms.first.push_back(next);
      unknowns.emplace_back();
      for (std::int32_t k = 0; k < height[c]; ++k) {
        auto& own = unknowns.back().emplace_back();
        const bool edge = c == 0 || c + 1 == height.size();
        for (int axis = edge ? 1 : 0; axis < 2; ++axis) {
          own.push_back(next++);
          freedoms.row_of.push_back(k + 2);
        }
      }
    }
    freedoms.first.push_back(next);
  }

  /// Those of the 3 x 3 nodes above and right of one; what is not there is left out.
  std::vector<std::int32_t> seen_from(std::size_t column, std::size_t row) const {
    std::vector<std::int32_t> all;
    for (std::size_t c = column; c < std::min(column + 3, height.size()); ++c) {
      for (std::size_t k = row; k < std::min(row + 3, unknowns[c].size()); ++k) {
        all.insert(all.end(), unknowns[c][k].begin(), unknowns[c][k].end());
      }
    }
    return all;
  }
};

/// Random springs among the nodes of each span.
Eigen::MatrixXd springs(const Nodes& nodes, ColumnMatrix& matrix) {
  std::mt19937 random(7);
  std::normal_distribution<double> any;
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(nodes.freedoms.count(), nodes.freedoms.count());
  for (std::size_t c = 0; c < nodes.height.size(); ++c) {
    for (std::size_t k = 0; k < nodes.unknowns[c].size(); ++k) {
      const auto at = nodes.seen_from(c, k);
      for (int spring = 0; spring < 3; ++spring) {
        std::vector<double> b;
        for (std::size_t i = 0; i < at.size(); ++i) b.push_back(any(random));
        for (std::size_t i = 0; i < at.size(); ++i) {
          for (std::size_t j = 0; j < at.size(); ++j) {
            dense(at[i], at[j]) += b[i] * b[j];
            matrix.add(at[i], at[j], b[i] * b[j]);
          }
        }
      }
    }
  }
  return dense;
}

class ColumnMatrixOf : public testing::TestWithParam<std::vector<std::int32_t>> {};

// Single precision: 6e-8 times a condition number of some hundred to thousand, and n roundings.
TEST_P(ColumnMatrixOf, SolvesAsADenseFactorDoes) {
  const Nodes nodes(GetParam());
  ColumnMatrix matrix(nodes.freedoms);
  const Eigen::MatrixXd dense = springs(nodes, matrix);
  const Eigen::VectorXd right = Eigen::VectorXd::Random(nodes.freedoms.count());
  ASSERT_TRUE(matrix.factorize());
  Eigen::VectorXd found = right;
  matrix.solve(found);
  const Eigen::VectorXd expected = dense.llt().solve(right);
  EXPECT_LT((found - expected).norm(), 1e-3 * expected.norm());
  EXPECT_LT((dense * found - right).norm(), 1e-3 * right.norm());
}

INSTANTIATE_TEST_SUITE_P(
    Heights, ColumnMatrixOf,
    testing::Values(std::vector<std::int32_t>{4, 4, 4, 4, 4, 4}, std::vector<std::int32_t>{5, 5, 5},
                    std::vector<std::int32_t>{9, 8, 6, 6, 5, 3, 2, 1, 1},  // a bank
                    std::vector<std::int32_t>{1, 2, 7, 3, 8, 8, 2},        // steps up and down
                    std::vector<std::int32_t>{0, 6, 5, 4, 0, 0, 5, 6, 0},  // ground in two parts
                    std::vector<std::int32_t>{7}, std::vector<std::int32_t>{3, 12}));

TEST(ColumnMatrix, AMatrixThatIsNotPositiveDefiniteIsSaid) {
  const Nodes nodes({4, 4, 4, 4});
  ColumnMatrix matrix(nodes.freedoms);
  springs(nodes, matrix);
  const std::int32_t last = nodes.freedoms.count() - 1;
  matrix.add(last, last, -1e3);
  EXPECT_FALSE(matrix.factorize());
}

// Of four columns of 20 nodes the outer have 20 unknowns, the inner 40. A pair's triangle stands in
// a rectangle of 61 x 40; runs of ten and their numbers: 20 + 2 x 40 and 40 + 2 x 20.
TEST(ColumnMatrix, TakesHalfASquareForTwoColumns) {
  const Nodes nodes({20, 20, 20, 20});
  EXPECT_EQ(ColumnMatrix::bytes(nodes.freedoms), 2 * 61 * 40 * 4 + 180 * (10 * 4 + 4));
}

}  // namespace
}  // namespace leda::solver::test
