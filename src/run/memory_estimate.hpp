// How much memory a run of a model will take, from the sizes of its fields, ghosts included, and of its structure.
#pragma once

#include "common/comm.hpp"
#include "setup/build_model.hpp"

namespace valsalva::run {

/// MB of 10^6 bytes.
struct MemoryEstimate {
  double fields_mb = 0;     ///< velocities, pressures and the work space of the pressure solve, all ranks
  double structure_mb = 0;  ///< nodes, springs, beams, tethers; every rank holds the whole
  double program_mb = 0;    ///< code, libraries and MPI's buffers on all ranks
  double regrid_mb = 0;     ///< of a second set of fields, while the grid changes; 0 on one level
  double total_mb() const { return fields_mb + structure_mb + program_mb; }  ///< between changes of the grid
};

/// Collective.
MemoryEstimate estimate_memory(setup::CaseModel& model, const Communicator& comm);

}  // namespace valsalva::run
