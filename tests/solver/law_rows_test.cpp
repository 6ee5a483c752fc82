// However the rows of the law table are numbered, points get the laws of their own rows.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "tests/solver/kernels.hpp"
#include "tests/solver/moving_bank.hpp"
#include "tests/solver/oracle.hpp"

namespace leda::solver::test {
namespace {

// The moving bank with a row for every band of its height, each stronger than the one above.
Seeded layered_bank(double bands_a_metre) {
  Seeded s = moving_bank();
  double height = 0;
  for (const Particle& p : s.particles) height = std::max(height, p.z);
  // More than a vector has lanes, or the whole table is looked up at once.
  const auto bands =
      std::max<std::size_t>(40, static_cast<std::size_t>(height * bands_a_metre) + 1);
  for (std::size_t i = 1; i < bands; ++i) {
    const double share = 1 + 0.01 * static_cast<double>(i);
    LawTable& t = s.laws;
    for (auto* column : {&t.bulk, &t.shear, &t.peak, &t.floor, &t.amplitude, &t.line_start,
                         &t.line_slope, &t.last, &t.tension, &t.sin_friction, &t.pore_pressure}) {
      column->push_back(column->front() * share);
    }
    for (auto* column : {&t.rate, &t.exp_end, &t.line_end}) column->push_back(column->front());
    t.softens.push_back(t.softens.front());
    t.material.push_back(t.material.front());
  }
  for (Particle& p : s.particles) {
    p.law = static_cast<std::int32_t>((height - p.z) * bands_a_metre);
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
        &LawTable::line_end, &LawTable::last, &LawTable::tension}) {
    move(column);
  }
  for (auto column : {&LawTable::softens, &LawTable::material}) move(column);
  for (Particle& p : s.particles) p.law = number[static_cast<std::size_t>(p.law)];
}

template <class Real>
Particles after_steps(const Seeded& s, const Kernel<Real>& kernel) {
  Model<Real> model = model_of<Real>(s);
  model.kernel = &kernel;
  take_steps(model, 8);
  return particles_of(model);
}

template <class Real>
class LawRowsOf : public ::testing::Test {};
TYPED_TEST_SUITE(LawRowsOf, BothPrecisions, PrecisionNames);

// A pack spans eight metres: bands of ten metres are one row to most packs, those of one metre lie
// within a vector of sixteen, three a metre within two; twenty, and shuffled ones, anywhere.
TYPED_TEST(LawRowsOf, PointsAreReadByTheirOwnNumbersHoweverFarApart) {
  for (const double bands_a_metre : {0.1, 1.0, 3.0, 20.0}) {
    const Seeded s = layered_bank(bands_a_metre);
    Seeded shuffled = s;
    std::vector<std::int32_t> number(s.laws.rows());
    std::iota(number.begin(), number.end(), 0);
    std::shuffle(number.begin(), number.end(), std::mt19937(3));
    renumber(shuffled, number);
    Oracle oracle(s.particles, s.size, s.laws, {});
    for (int i = 0; i < 8; ++i) oracle.step({1e-3, gravity, 0.02, true});
    for (const auto& here : kernels_here<TypeParam>()) {
      const Particles a = after_steps(s, *here.kernel), b = after_steps(shuffled, *here.kernel);
      const double t = within<TypeParam>(2e-5, 1e-12);
      for (const auto stress : {&Particle::sxx, &Particle::szz, &Particle::sxz, &Particle::syy}) {
        EXPECT_EQ(difference(a, b, stress), 0) << here.name << ", " << bands_a_metre;
        EXPECT_LT(difference(a, oracle.particles(), stress), t)
            << here.name << ", " << bands_a_metre;
      }
    }
  }
}

}  // namespace
}  // namespace leda::solver::test
