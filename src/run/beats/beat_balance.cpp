#include "run/beats/beat_balance.hpp"

#include "common/units.hpp"
#include "coupling/coupled_model.hpp"
#include "ib3d/fluid/kinetic_energy.hpp"

namespace valsalva::run {

BalanceState balance_state(const lumped::LumpedNetwork& network, const lumped::LumpedState& state)
{
  return {.network = network.balance(state)};
}

BalanceState balance_state(const coupling::CoupledModel& model)
{
  const ib3d::NavierStokes& fluid = model.solver().fluid();
  BalanceState s = balance_state(model.circulation().network(), model.circulation().state());
  s.root_work_mJ = common::mJ_from_mmHg_ml(model.pressure_work());
  s.root_kinetic_inflow_mJ = common::mJ_from_mmHg_ml(model.kinetic_inflow());
  s.root_energy_mJ = common::mJ_from_erg(
      ib3d::kinetic_energy(fluid.grid(), fluid.u(), fluid.fluid().density) + model.solver().elastic_energy());
  return s;
}

BeatBalance balance_between(const BalanceState& begin, const BalanceState& end)
{
  using common::mJ_from_mmHg_ml;
  BeatBalance b;
  b.network_inflow_ml = end.network.inflow - begin.network.inflow;
  b.network_volume_change_ml = end.network.volume - begin.network.volume;
  b.volume_residual_ml = b.network_inflow_ml - b.network_volume_change_ml;
  b.source_work_mJ = mJ_from_mmHg_ml(end.network.work - begin.network.work);
  b.network_loss_mJ = mJ_from_mmHg_ml(end.network.loss - begin.network.loss);
  b.network_energy_change_mJ = mJ_from_mmHg_ml(end.network.energy - begin.network.energy);
  b.root_work_mJ = end.root_work_mJ - begin.root_work_mJ;
  b.root_kinetic_inflow_mJ = end.root_kinetic_inflow_mJ - begin.root_kinetic_inflow_mJ;
  b.root_energy_change_mJ = end.root_energy_mJ - begin.root_energy_mJ;
  b.root_loss_mJ = b.root_work_mJ + b.root_kinetic_inflow_mJ - b.root_energy_change_mJ;
  b.energy_residual_mJ = b.source_work_mJ - b.network_loss_mJ - b.network_energy_change_mJ - b.root_work_mJ;
  return b;
}

}  // namespace valsalva::run
