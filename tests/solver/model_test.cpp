// A model over many steps: strays, creep, balances, whole runs in both precisions.
#include "solver/kernel/model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "solver/run/simulate.hpp"
#include "tests/solver/block.hpp"
#include "tests/solver/moving_bank.hpp"

namespace leda::solver::test {
namespace {

template <class Real>
class ModelOf : public ::testing::Test {};
TYPED_TEST_SUITE(ModelOf, BothPrecisions, PrecisionNames);

// Points carried out of their cells are served one by one until they are put into their new cells;
// both ways must lead to the same motion, but for the order of sums.
TYPED_TEST(ModelOf, StraysMoveAsIfTheyHadBeenArranged) {
  Model<TypeParam> strayed = model_of<TypeParam>(moving_bank());
  std::mt19937 random(7);
  shake(strayed.packs, strayed.grid, random);
  Model<TypeParam> arranged = strayed;
  spread_anew(strayed);
  ASSERT_TRUE(tidy_up(arranged));
  spread_anew(arranged);
  take_steps(strayed, 3);
  take_steps(arranged, 3);
  EXPECT_GT(strayed.strayed, 300U);
  const Particles a = particles_of(strayed), b = particles_of(arranged);
  const double t = within<TypeParam>(1e-4, 1e-11);
  for (const auto number : {&Particle::x, &Particle::vx, &Particle::vz, &Particle::szz,
                            &Particle::sxz, &Particle::plastic_strain}) {
    EXPECT_LT(difference(a, b, number), t);
  }
}

TYPED_TEST(ModelOf, ConservesMassAndMomentum) {
  Model<TypeParam> model = model_of<TypeParam>(moving_bank());
  take_steps(model, 4);
  const Balances balances = transfer_balance(model);
  EXPECT_LT(balances.mass, within<TypeParam>(1e-6, 1e-13));
  EXPECT_LT(balances.momentum, within<TypeParam>(1e-6, 1e-13));
}

TYPED_TEST(ModelOf, ConvertsToTheOtherPrecisionAndBack) {
  const Seeded s = moving_bank();
  const Model<TypeParam> model = model_of<TypeParam>(s);
  const auto narrow = converted<float>(model, s.size, s.laws, {});
  const auto wide = converted<double>(narrow, s.size, s.laws, {});
  const Particles a = particles_of(model), b = particles_of(wide);
  for (const auto& number : point_numbers<double>) {
    if (number.value == nullptr) continue;
    EXPECT_LT(difference(b, a, number.value), 1e-7) << number.name;
  }
}

// Steps of 1e-9 at a strain of 1: each is lost to single precision, their sum is not.
TEST(Model, DoesNotLoseCreep) {
  Seeded s = moving_bank();
  for (Particle& p : s.particles) p.vx = p.vz = 0;
  Model<float> model = model_of<float>(s);
  for (Pack<float>& pack : model.packs.pack) {
    std::ranges::fill(pack.plastic_strain, 1.0F);
    std::ranges::fill(pack.plastic_rest, -4e-8F);
  }
  // The remolded clay yields under its own weight; each lane that does takes up its rest.
  take_steps(model, 1);
  std::size_t grown = 0;
  for_each_point(model.packs, [&](std::size_t i, std::size_t l) {
    const double sum = static_cast<double>(model.packs.pack[i].plastic_strain[l]) -
                       static_cast<double>(model.packs.pack[i].plastic_rest[l]);
    if (sum > 1 + 4e-8 - 1e-12) ++grown;
  });
  EXPECT_EQ(grown, model.packs.count);
}

// Runs of everything that a law can have: the same distance within a cell, whatever the precision.
TEST(Model, SinglePrecisionAndRestGiveTheRetrogressionOfDoubleWithoutRest) {
  Section plain = bank(10, 30, 27e3), rated = bank(10, 30, 24e3), nearly = bank(10, 30, 27e3);
  rated.materials["clay"].rate = SemiLogarithmicRate{0.1, 1e-3};
  nearly.materials["clay"].poisson_ratio = 0.49;
  RunSettings settings = coarse();
  settings.trigger = UndrainedTrigger{4.0};
  for (const Section& section : {plain, rated, nearly}) {
    RunSettings full = settings;
    full.precision = Precision::double_precision;
    full.ground_rests = false;
    const SectionResult a = simulate(section, settings), b = simulate(section, full);
    EXPECT_NEAR(a.crest_to_crest_retrogression_m, b.crest_to_crest_retrogression_m,
                settings.resolution.cell_m);
    EXPECT_NEAR(a.runout_m, b.runout_m, settings.resolution.cell_m);
  }
}

TEST(Model, AnyNumberOfThreadsGivesTheSameRun) {
  RunSettings settings = coarse();
  settings.stop.max_time_s = 4;
  Frame one, many;
  Listener listener;
  listener.frame = [&](const Frame& f) { one = f; };
  const SectionResult a = simulate(bank(10, 30, 25e3), settings, listener);
  for (const int threads : {2, 3, 8}) {
    listener.frame = [&](const Frame& f) { many = f; };
    const SectionResult b = simulate(bank(10, 30, 25e3), settings, listener, threads);
    EXPECT_EQ(a.steps, b.steps);
    EXPECT_EQ(a.balances.energy, b.balances.energy);
    for (const FrameField& field : frame_fields) {
      EXPECT_EQ(one.*field.values, many.*field.values) << field.name;
    }
  }
}

}  // namespace
}  // namespace leda::solver::test
