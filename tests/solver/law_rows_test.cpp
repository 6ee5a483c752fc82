// However the rows of the law table are numbered, points get the laws of their own rows.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "hwy/targets.h"
#include "solver/kernel/packed_stage.hpp"
#include "tests/solver/moving_bank.hpp"

namespace leda::solver::test {
namespace {

// The moving bank with a row for every band of its height, each stronger than the one above.
Seeded layered_bank(double bands_a_metre) {
  Seeded s = moving_bank();
  const double height = *std::max_element(s.particles.z.begin(), s.particles.z.end());
  // More than a vector has lanes, or the whole table is looked up at once.
  const auto bands =
      std::max<std::size_t>(40, static_cast<std::size_t>(height * bands_a_metre) + 1);
  for (std::size_t i = 1; i < bands; ++i) {
    const double share = 1 + 0.01 * static_cast<double>(i);
    LawTable& t = s.laws;
    for (auto* column : {&t.bulk, &t.shear, &t.peak, &t.floor, &t.amplitude, &t.line_start,
                         &t.line_slope, &t.last}) {
      column->push_back(column->front() * share);
    }
    for (auto* column : {&t.rate, &t.exp_end, &t.line_end}) column->push_back(column->front());
    t.softens.push_back(t.softens.front());
    t.material.push_back(t.material.front());
  }
  for (std::size_t i = 0; i < s.particles.padded(); ++i) {
    s.particles.law[i] = static_cast<std::int32_t>((height - s.particles.z[i]) * bands_a_metre);
  }
  return s;
}

// The same laws under other numbers.
void renumber(Seeded& s, const std::vector<std::int32_t>& number) {
  const LawTable before = s.laws;
  LawTable& t = s.laws;
  const auto move = [&](auto column) {
    for (std::size_t i = 0; i < number.size(); ++i) {
      (t.*column)[static_cast<std::size_t>(number[i])] = (before.*column)[i];
    }
  };
  for (auto column :
       {&LawTable::bulk, &LawTable::shear, &LawTable::peak, &LawTable::floor, &LawTable::amplitude,
        &LawTable::rate, &LawTable::exp_end, &LawTable::line_start, &LawTable::line_slope,
        &LawTable::line_end, &LawTable::last}) {
    move(column);
  }
  for (auto column : {&LawTable::softens, &LawTable::material}) move(column);
  for (auto& law : s.particles.law) law = number[static_cast<std::size_t>(law)];
}

Particles after_steps(Seeded s) {
  auto stage = begin_packed_stage(s.particles, s.grid, s.laws);
  Team team(1);
  bool left = false;
  for (int i = 1; i <= 8; ++i) step(*stage, {1e-3, gravity, 0.02, true}, i == 8, team, left);
  EXPECT_FALSE(left);
  unpack(stage->packs, stage->grid, s.particles);
  return s.particles;
}

// A pack spans eight metres: bands of ten metres are one row to most packs, those of one metre lie
// within a vector of sixteen, three a metre within two; twenty, and shuffled ones, anywhere.
void expect_own_rows() {
  for (const double bands_a_metre : {0.1, 1.0, 3.0, 20.0}) {
    const Seeded s = layered_bank(bands_a_metre);
    Seeded shuffled = s;
    std::vector<std::int32_t> number(s.laws.rows());
    std::iota(number.begin(), number.end(), 0);
    std::shuffle(number.begin(), number.end(), std::mt19937(3));
    renumber(shuffled, number);
    Particles a = after_steps(s), b = after_steps(shuffled);
    const auto all_a = a.arrays(), all_b = b.arrays();
    for (std::size_t i = 0; i < all_a.size(); ++i) EXPECT_EQ(*all_a[i], *all_b[i]);
    // ... and the reference, which knows one row and any.
    Seeded reference = s;
    for (int i = 0; i < 8; ++i) {
      step(reference.particles, reference.grid, reference.laws, {1e-3, gravity, 0.02, true});
    }
    EXPECT_LT(difference(a.szz, reference.particles.szz, a.count), 2e-5) << bands_a_metre;
    EXPECT_LT(difference(a.sxz, reference.particles.sxz, a.count), 2e-5) << bands_a_metre;
  }
}

TEST(LawRows, AreReadByTheirOwnNumbersHoweverFarApart) { expect_own_rows(); }

TEST(LawRows, AreReadSoWithShorterVectors) {
  for (const std::int64_t off : {HWY_AVX3 | HWY_AVX3_DL, HWY_AVX3 | HWY_AVX3_DL | HWY_AVX2}) {
    hwy::DisableTargets(off);
    expect_own_rows();
    hwy::DisableTargets(0);
  }
}

}  // namespace
}  // namespace leda::solver::test
