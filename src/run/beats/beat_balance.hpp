// What a beat did to the volume and the energy of the circulation and of the 3D root (docs/scheme.md, section 4).
//   network   work of sources and contracting walls = loss in resistances + change of what compliances and
//             inertances hold + work on the root + residual
//   root      work of the opening pressures + kinetic energy carried in = change of kinetic and elastic energy + loss;
//             the loss is the rest: viscosity, the dissipation of the scheme, and the stabilisation of the openings
// ml and mJ.
#pragma once

#include "lumped/network/network.hpp"

namespace valsalva::coupling {
class CoupledModel;
}

namespace valsalva::run {

/// Totals since the start at one instant. The root's are zero in a 0D run.
struct BalanceState {
  lumped::Balance network;
  double root_work_mJ = 0, root_kinetic_inflow_mJ = 0;
  double root_energy_mJ = 0;  ///< kinetic and elastic
};

/// Of a 0D run; the root's totals are 0. std::logic_error unless the network was built with NetworkSpec::balance.
BalanceState balance_state(const lumped::LumpedNetwork& network, const lumped::LumpedState& state);
/// Of a coupled run; errors as above. Collective.
BalanceState balance_state(const coupling::CoupledModel& model);

/// One column of beats.csv each (docs/outputs.md).
struct BeatBalance {
  double network_inflow_ml = 0, network_volume_change_ml = 0, volume_residual_ml = 0;
  double source_work_mJ = 0, network_loss_mJ = 0, network_energy_change_mJ = 0;
  double root_work_mJ = 0, root_kinetic_inflow_mJ = 0, root_energy_change_mJ = 0, root_loss_mJ = 0;
  double energy_residual_mJ = 0;
};

/// The differences of two totals, `end` the later one, with the residuals and the loss in the root that follow from them.
BeatBalance balance_between(const BalanceState& begin, const BalanceState& end);

}  // namespace valsalva::run
