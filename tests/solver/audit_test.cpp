#include "solver/run/audit.hpp"

#include <gtest/gtest.h>

#include "tests/solver/block.hpp"

namespace leda::solver::test {
namespace {

// A swinging elastic column: what motion loses, stress and gravity gain.
TEST(Audit, EnergyOfASwingingColumnIsBalanced) {
  Block<double> b(0.5, 1, 14, 0, 0, 1, 10, {1e7, 0.2, 1500, 1e30});
  AnyModel any = b.model();
  auto& model = std::get<Model<double>>(any);
  EnergyAudit audit = begin_audit(any, b.laws);
  const StepSettings settings{b.time_step(0.25), 9.81, 0.0, true};
  ThreadTeam team(1);
  for (int i = 0; i < 2000; ++i) {
    if (i % 10 == 0) {
      ASSERT_TRUE(tidy_up(model));
    }
    audit.add(step(model, settings, false, team), settings);
  }
  EXPECT_GT(audit.kinetic_peak, 0.1 * audit.scale());
  EXPECT_LT(std::abs(audit.residual()), 0.02);
  // No plasticity: what stress took is what it holds (strains stay near 1 %).
  EXPECT_NEAR(audit.plastic_work(elastic_energy(any, b.laws)), 0, 0.03);
  EXPECT_GE(audit.transfer_loss, 0);
}

TEST(Audit, EnergyOutOfNothingIsSeen) {
  EnergyAudit audit;
  audit.least_scale = 1;
  StepSums sums;
  audit.add(sums, {0.1, 9.81, 0, true});
  sums.grid.kinetic_after = 100;  // no work was done
  audit.add(sums, {0.1, 9.81, 0, true});
  EXPECT_GT(audit.residual(), 0.9);
}

TEST(Audit, MissingMassIsSeen) {
  Block<double> b(0.5, 10, 10, 3, 3, 3, 3, {});
  auto model = b.model();
  EXPECT_LT(transfer_balance(model).mass, 1e-13);
  Kernel<double> forgets = *model.kernel;
  forgets.spread = [](Packs<double>& packs, Grid<double>& grid, std::size_t first,
                      std::size_t last) {
    return first == last || kernel<double>().spread(packs, grid, first + 1, last);
  };
  model.kernel = &forgets;
  EXPECT_GT(transfer_balance(model).mass, 1e-3);
}

}  // namespace
}  // namespace leda::solver::test
