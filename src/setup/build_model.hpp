// From a Case to the objects of a coupled run.
#pragma once

#include <array>

#include "common/comm.hpp"
#include "coupling/coupled_model.hpp"
#include "ib3d/structure/aortic_root/aortic_root.hpp"
#include "setup/case.hpp"
#include "setup/periodic_start.hpp"

namespace valsalva::setup {

/// The elastic structure and, for the aortic root, what form-finding found.
struct BuiltStructure {
  ib3d::FibreNetwork network;
  std::array<ib3d::LeafletShape, 3> closed, start;  ///< of the aortic root only
};
/// The leaflets start in equilibrium with the larger of leaflets.start_pressure_mmHg and `valve_load_mmHg`. CaseError
/// where nodes leave the box or fibre files are wrong, SolverError where no leaflet shape is found.
BuiltStructure build_structure(const Case& c, double valve_load_mmHg = 0);

/// Everything of a coupled run, built and owned together. Collective.
class CaseModel {
 public:
  /// Errors as `build_structure` and `network_start`. `timers` must outlive the model.
  CaseModel(const Case& c, const Communicator& comm, Timers& timers);
  CaseModel(const CaseModel&) = delete;
  CaseModel& operator=(const CaseModel&) = delete;

  const ib3d::Hierarchy& grid() const { return solver_.fluid().grid(); }
  const BuiltStructure& structure() const { return structure_; }
  const NetworkStart& start() const { return start_; }
  ib3d::ImmersedBoundarySolver& solver() { return solver_; }
  coupling::Circulation& circulation() { return circulation_; }
  coupling::CoupledModel& model() { return model_; }

 private:
  NetworkStart start_;
  coupling::Circulation circulation_;
  ib3d::RefinementPolicy refinement_;
  BuiltStructure structure_;
  ib3d::ImmersedBoundarySolver solver_;
  coupling::CoupledModel model_;
};

}  // namespace valsalva::setup
