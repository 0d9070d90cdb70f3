// From the case file to the objects of a run: the only place where keys and their units become CGS structs.
// A case without [[opening]] is purely 0D. Every function throws CaseError with the place of what is wrong.
#pragma once

#include <mpi.h>

#include <array>

#include "casefile/case_file.hpp"
#include "coupling/coupled_model.hpp"
#include "ib3d/grid/refinement.hpp"
#include "ib3d/structure/aortic_root/aortic_root.hpp"
#include "setup/network_from_case.hpp"
#include "setup/periodic_start.hpp"

namespace valsalva::setup {

/// Whether the case has no opening.
bool is_lumped(const CaseFile& c);

/// Box and sides, cm.
ib3d::Domain domain_from_case(const CaseFile& c);
/// Levels, margin and regions of [grid] and [[refine]], with those about the openings.
ib3d::RefinementPolicy refinement_from_case(const CaseFile& c);
/// In the order of the case; discs that leave their side or overlap are refused.
std::vector<ib3d::Opening> openings_from_case(const CaseFile& c, const ib3d::Domain& domain);
/// cm, along the whole length of the domain.
ib3d::RootDimensions root_dimensions_from_case(const CaseFile& c, const ib3d::Domain& domain);
/// s.
coupling::StepControl step_control_from_case(const CaseFile& c);

/// The elastic structure and, for the aortic root, what form-finding found.
struct Structure {
  ib3d::FibreNetwork network;
  std::array<ib3d::LeafletShape, 3> closed, start;  ///< of kind "aortic_root" only
  bool is_root = false;
};
/// The leaflets start in equilibrium with the larger of leaflets.start_pressure_mmHg and `valve_load_mmHg`.
Structure structure_from_case(const CaseFile& c, const ib3d::Domain& domain, double h,
                              double valve_load_mmHg = 0);

/// Everything of a coupled run, built and owned together. Collective.
class CaseModel {
 public:
  /// SolverError where no leaflet shape or periodic start is found. `timers` must outlive the model.
  CaseModel(const CaseFile& c, MPI_Comm comm, Timers& timers);
  CaseModel(const CaseModel&) = delete;
  CaseModel& operator=(const CaseModel&) = delete;

  const ib3d::Hierarchy& grid() const { return root_.fluid().grid(); }
  const Structure& structure() const { return structure_; }
  const NetworkStart& start() const { return start_; }
  ib3d::ImmersedBoundarySolver& root() { return root_; }
  coupling::Circulation& circulation() { return circulation_; }
  coupling::CoupledModel& model() { return model_; }

 private:
  NetworkStart start_;
  coupling::Circulation circulation_;
  ib3d::Domain domain_;
  ib3d::RefinementPolicy refinement_;
  Structure structure_;
  ib3d::ImmersedBoundarySolver root_;
  coupling::CoupledModel model_;
};

}  // namespace valsalva::setup
