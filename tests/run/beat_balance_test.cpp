// Volume and energy of a coupled step: a tube of fluid without friction loses nothing, and the network's books close
// with what the tube was given.
#include "run/beats/beat_balance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coupling/tube_model.hpp"

namespace valsalva::run {

using namespace coupling;
namespace {

BeatBalance balance_of_tube(double dt)
{
  const TubeLoad load;
  lumped::NetworkSpec network = tube_network(load);
  network.balance = true;
  StepControl control;
  control.dt_fixed_s = dt;
  TubeModel tube{network, CouplingScheme::implicit_, control};
  const BalanceState begin = balance_state(tube.model);
  while (tube.model.t() < 0.06 - 1e-12) tube.model.advance(tube.model.next_step(0.06));
  const BeatBalance b = balance_between(begin, balance_state(tube.model));
  const double Q = tube.flow(), energy = 0.5 * kTubeInertance * Q * Q;
  EXPECT_NEAR(b.root_energy_change_mJ, common::mJ_from_mmHg_ml(energy), 1e-9 * b.root_energy_change_mJ);
  // Plug flow through an opening of 1 cm^2.
  EXPECT_NEAR(tube.root.fluid().kinetic_outflow()[1], 0.53 * Q * Q * Q, 1e-9 * std::abs(Q * Q * Q));
  return b;
}

TEST(BeatBalance, ATubeWithoutFrictionTurnsAllWorkIntoKineticEnergy)
{
  const BeatBalance b = balance_of_tube(1e-3);
  EXPECT_GT(b.root_work_mJ, 0.0);
  // What flows in carries as much kinetic energy as what flows out.
  EXPECT_NEAR(b.root_kinetic_inflow_mJ, 0.0, 1e-9 * b.root_work_mJ);
  EXPECT_NEAR(b.root_loss_mJ, 0.0, 1e-8 * b.root_work_mJ);
}

TEST(BeatBalance, NetworkAndTubeCloseToSecondOrderInTheStep)
{
  const BeatBalance coarse = balance_of_tube(1e-3), fine = balance_of_tube(5e-4);
  EXPECT_LT(std::abs(fine.energy_residual_mJ), 1e-3 * fine.source_work_mJ);
  EXPECT_NEAR(coarse.energy_residual_mJ / fine.energy_residual_mJ, 4.0, 0.4);
  EXPECT_NEAR(fine.volume_residual_ml, 0.0, 1e-9 * fine.network_volume_change_ml);
  EXPECT_GT(fine.network_loss_mJ, 0.0);
}

TEST(BeatBalance, TakesTheDifferencesOfTotals)
{
  BalanceState begin, end;
  begin.network = {10, 1000, 400, 50, 300};
  end.network = {15, 3000, 1400, 54, 500};
  begin.root_work_mJ = 5;
  end.root_work_mJ = 85;
  end.root_kinetic_inflow_mJ = -20;
  begin.root_energy_mJ = 7;
  end.root_energy_mJ = 17;
  const BeatBalance b = balance_between(begin, end);
  EXPECT_DOUBLE_EQ(b.volume_residual_ml, 1.0);
  EXPECT_DOUBLE_EQ(b.root_loss_mJ, 80 - 20 - 10);
  // 2000 - 1000 - 200 mmHg ml, less the work on the root.
  EXPECT_NEAR(b.energy_residual_mJ, 800 * 0.133322 - 80, 1e-9);
}

}  // namespace
}  // namespace valsalva::run
