// The kernel, in both precisions and at every width of vectors, against the oracle: every law,
// every branch of a softening curve, averaged dilation, long steps, each edge of the model, points
// that change their cells, materials mixed within a cell.
#include "tests/solver/oracle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "tests/solver/block.hpp"
#include "tests/solver/kernels.hpp"
#include "tests/solver/moving_bank.hpp"

namespace leda::solver::test {
namespace {

constexpr int steps = 50;

struct Scene {
  std::string name;
  Seeded seeded;
  ModelSettings settings;

  double dt() const { return 0.25 * seeded.size.h / seeded.laws.stiffest_speed; }
};

// A bank whose points move by up to a cell in the run and against every edge; two materials take
// turns within each cell. Plastic strains reach from the first branch of the softening curve to
// beyond the last; all ground has yielded, so that no last digit decides who has.
Scene scene(const std::string& name, Section section, const ModelSettings& settings = {}) {
  section.materials["weak"] = section.materials["clay"];
  section.materials["weak"].peak_strength.constant_Pa *= 0.7;
  Scene s{name, seed_particles(section, {}), settings};
  // The rows of both materials, whether or not a layer has them.
  LawTableBuilder builder(section, 1);
  for (std::size_t m = 0; m < 2; ++m) builder.row(m, 0, 0);
  s.seeded.laws = builder.table();
  const double end = s.seeded.laws.line_end[0];
  const double beyond = std::isfinite(end) ? 1.2 * end : 2.0;
  for (std::size_t i = 0; i < s.seeded.particles.size(); ++i) {
    Particle& p = s.seeded.particles[i];
    p.vx = 6 * std::sin(0.2 * p.x) * (0.3 + p.z / 13);
    p.vz = -5 * std::cos(0.15 * p.x) * (0.3 + p.z / 13);
    p.law = static_cast<std::int32_t>(i % 2);
    p.plastic_strain = beyond * std::pow(static_cast<double>(i % 17 + 1) / 17, 3);
  }
  s.settings.rests = false;
  return s;
}

Section with(SofteningLaw law, Regularization regularization = Regularization::none) {
  Section s = bank(10, 30, 25e3);
  s.materials["clay"].softening = Softening{std::move(law), 0.014, regularization};
  return s;
}

Section with_band(double band_m) {
  Section s = with(UrmiSoftening{0.95, 2.8, 1.8, 500, {}, {}}, Regularization::band);
  s.materials["clay"].softening->band_m = band_m;
  return s;
}

Section with_rate(const RateLaw& rate) {
  Section s = bank(10, 30, 25e3);
  s.materials["clay"].rate = rate;
  return s;
}

Section with_flow(const FlowLaw& flow) {
  Section s = bank(10, 30, 25e3);
  s.materials["clay"].flow = flow;
  return s;
}

std::vector<Scene> scenes() {
  Section plastic = bank(10, 30, 25e3), nearly = bank(10, 30, 25e3);
  plastic.materials["clay"].softening.reset();
  nearly.materials["clay"].poisson_ratio = 0.499;
  Section thick_nearly = with_band(5);
  thick_nearly.materials["clay"].poisson_ratio = 0.49;
  Section cracked = with(UrmiSoftening{0.95, 2.8, 1.8, 500, {}, {}});
  cracked.materials["clay"].tensile_strength_Pa = 12e3;
  Section drained = with(UrmiSoftening{0.95, 2.8, 1.8, 500, {}, {}});
  Material& sand = drained.materials["sand"] = drained.materials["clay"];
  sand.softening.reset();
  sand.drained = DrainedStrength{2e3, 33};
  sand.drains = true;
  Layer crust;
  crust.material = "sand";
  crust.thickness_m = 3;
  drained.layers.insert(drained.layers.begin(), crust);
  Section all = with_rate(SemiLogarithmicRate{0.1, 1e-4});
  all.materials["clay"].flow = BinghamFlow{300};
  all.materials["clay"].tensile_strength_Pa = 12e3;
  all.materials["clay"].poisson_ratio = 0.49;
  return {
      scene("perfectly plastic", plastic),
      scene("urmi", with(UrmiSoftening{0.95, 2.8, 1.8, 500, {}, {}})),
      scene("urmi, beta scaled", bank(10, 30, 25e3)),
      scene("einav-randolph", with(EinavRandolphSoftening{500, 1.2})),
      scene("exponential", with(ExponentialSoftening{500, 3})),
      scene("linear", with(LinearSoftening{500, 1.5})),
      scene("band of two cells", with_band(2)),
      scene("band of five cells", with_band(5)),
      scene("band, averaged dilation", thick_nearly, {.averages = true}),
      scene("band, long steps", with_band(5), {.softer = true}),
      scene("dey", with(DeySoftening{2000, 0.4, 3, 500})),
      scene("tension cut-off", cracked),
      scene("drained crust on clay", drained),
      scene("semi-logarithmic rate", with_rate(SemiLogarithmicRate{0.1, 1e-4})),
      scene("power rate", with_rate(PowerRate{0.08, 1e-4})),
      scene("additive power rate", with_rate(AdditivePowerRate{0.3, 0.5, 1e-2})),
      scene("bingham flow", with_flow(BinghamFlow{500})),
      scene("herschel-bulkley flow", with_flow(HerschelBulkleyFlow{300, 0.4})),
      scene("averaged dilation", nearly, {.averages = true}),
      scene("long steps", bank(10, 30, 25e3), {.softer = true}),
      scene("rate, flow, averages, long steps", all, {.softer = true, .averages = true}),
  };
}

// A third of the ground has not yielded. With alpha below 1 the strength drops by 5 % at the first
// yield, so the last digit may put that drop off by a step: a comparison for double precision.
Scene first_yield() {
  Scene s = scene("first yield", with(UrmiSoftening{0.95, 2.8, 1.8, 500, {}, {}}));
  for (std::size_t i = 0; i < s.seeded.particles.size(); i += 3) {
    s.seeded.particles[i].plastic_strain = 0;
  }
  return s;
}

// Numbers that share a scale.
struct Kind {
  std::vector<double Particle::*> numbers;
  double least;  ///< of the scale
};

std::vector<Kind> kinds(const Scene& s) {
  using P = Particle;
  return {{{&P::x, &P::z}, s.seeded.size.h},
          {{&P::vx, &P::vz}, 0.1},
          {{&P::cxx, &P::cxz, &P::czx, &P::czz}, 0.1},
          {{&P::sxx, &P::szz, &P::sxz, &P::syy}, s.seeded.laws.peak[0]},
          {{&P::plastic_strain}, 0.01},
          {{&P::mass}, 1},
          {{&P::volume}, 0.01}};
}

// The largest size of a kind in the cell of each particle and the eight around it: what sums there
// are made of. A large value elsewhere hides nothing. Positions are kept within their cells, so
// theirs is the cell.
std::vector<double> local_scale(const Kind& kind, const Particles& particles, double h) {
  std::map<std::pair<long, long>, double> cells;
  const auto cell = [h](const Particle& p) {
    return std::pair(std::lround(std::floor(p.x / h)), std::lround(std::floor(p.z / h)));
  };
  const bool place = kind.numbers[0] == &Particle::x;
  for (const Particle& p : particles) {
    for (const auto number : kind.numbers) {
      double& most = cells[cell(p)];
      most = std::max({most, kind.least, place ? 0.0 : std::abs(p.*number)});
    }
  }
  std::vector<double> scale;
  for (const Particle& p : particles) {
    double most = kind.least;
    for (long i = -1; i <= 1; ++i) {
      for (long k = -1; k <= 1; ++k) {
        const auto found = cells.find({cell(p).first + i, cell(p).second + k});
        if (found != cells.end()) most = std::max(most, found->second);
      }
    }
    scale.push_back(most);
  }
  return scale;
}

// Largest difference over its local scale, and of which particle.
std::pair<double, std::string> worst(const Particles& found, const Particles& expected,
                                     const Scene& s) {
  std::pair<double, std::string> most{0, ""};
  for (const Kind& kind : kinds(s)) {
    const auto scale = local_scale(kind, expected, s.seeded.size.h);
    for (std::size_t n = 0; n < kind.numbers.size(); ++n) {
      const auto number = kind.numbers[n];
      for (std::size_t i = 0; i < expected.size(); ++i) {
        const double off = std::abs(found[i].*number - expected[i].*number) / scale[i];
        if (off <= most.first) continue;
        most = {off, "number " + std::to_string(n) + " of scale " + std::to_string(scale[i]) +
                         ", particle " + std::to_string(i)};
      }
    }
  }
  return most;
}

// Double has 16 digits, of which sums of some thousand terms take three; single has 7, and stresses
// are differences of values up to ten times as large; in ground that cracks, whose pull takes its
// mean stress away as well, of values thirty times as large. Without fused products every product
// is rounded once more.
template <class Real>
double tolerance(bool fuses, bool cracks = false) {
  return (sizeof(Real) == 4 ? (cracks ? 3e-5 : 1e-5) : 1e-12) * (fuses ? 1 : 2);
}

bool cracks(const Scene& s) {
  return std::ranges::any_of(s.seeded.laws.tension, [](double t) { return t < beyond_reach; });
}

template <class Real>
class Kernels : public ::testing::Test {};
TYPED_TEST_SUITE(Kernels, BothPrecisions, PrecisionNames);

TYPED_TEST(Kernels, StepAsTheOracleDoes) {
  auto all = scenes();
  if (sizeof(TypeParam) == 8) all.push_back(first_yield());
  for (const Scene& s : all) {
    Oracle oracle(s.seeded.particles, s.seeded.size, s.seeded.laws, s.settings);
    std::vector<Model<TypeParam>> models;
    const auto kernels = kernels_here<TypeParam>();
    for (const auto& here : kernels) {
      models.push_back(model_of<TypeParam>(s.seeded, s.settings));
      models.back().kernel = here.kernel;
    }
    ThreadTeam team(1);
    const StepSettings settings{s.dt(), gravity, 0.02, true};
    StepSums expected;
    for (int i = 1; i <= steps; ++i) {
      expected = oracle.step(settings);
      for (auto& model : models) {
        const StepSums found = step(model, settings, i == steps, team);
        ASSERT_FALSE(found.points.left_grid) << s.name;
        if (i % 7 == 0) {  // points are at home, or strays, by turns
          ASSERT_TRUE(tidy_up(model));
        }
        if (i < steps) continue;
        const double t = 10 * tolerance<TypeParam>(false);
        EXPECT_NEAR(found.grid.kinetic_after / expected.grid.kinetic_after, 1, t) << s.name;
        EXPECT_NEAR(found.points.stress_work / expected.points.stress_work, 1, 100 * t) << s.name;
      }
    }
    for (std::size_t k = 0; k < models.size(); ++k) {
      const auto [off, what] = worst(particles_of(models[k]), oracle.particles(), s);
      EXPECT_LT(off, tolerance<TypeParam>(kernels[k].fuses, cracks(s)))
          << s.name << ", " << kernels[k].name << ": " << what;
    }
  }
}

// Products and sums are fused where the code says so and nowhere else, and lanes are summed in one
// order, so the width of the vectors changes nothing. SSE4 cannot fuse.
TYPED_TEST(Kernels, GiveTheSameBytesWhateverTheWidthOfTheVectors) {
  auto all = scenes();
  for (Scene& s : all) {
    s.settings.rests = true;
    std::optional<Particles> first;
    std::size_t compared = 0;
    for (const auto& here : kernels_here<TypeParam>()) {
      if (!here.fuses) continue;
      Model<TypeParam> model = model_of<TypeParam>(s.seeded, s.settings);
      model.kernel = here.kernel;
      std::mt19937 random(11);
      for (int i = 0; i < 3; ++i) {
        take_steps(model, 3, 1, s.dt());
        ASSERT_TRUE(tidy_up(model));
        shake(model.packs, model.grid, random);  // strays of both halves of a pack
        if (s.settings.averages) {
          ASSERT_TRUE(tidy_up(model));
        }
        spread_anew(model);
        take_steps(model, 2, 2, s.dt());
      }
      take_steps(model, 40, 1, s.dt());  // beyond a decision who rests
      const Particles found = particles_of(model);
      if (first) expect_same_bytes(found, *first);
      first = found;
      ++compared;
    }
    EXPECT_GE(compared, 2U) << "this processor has no AVX2";
  }
}

TYPED_TEST(Kernels, GiveTheSameBytesWithAnyNumberOfThreads) {
  for (const Scene& s : scenes()) {
    std::optional<Particles> first;
    for (const int threads : {1, 2, 3}) {
      Model<TypeParam> model = model_of<TypeParam>(s.seeded, s.settings);
      take_steps(model, 20, threads, s.dt());
      const Particles found = particles_of(model);
      if (first) expect_same_bytes(found, *first);
      first = found;
    }
  }
}

}  // namespace
}  // namespace leda::solver::test
