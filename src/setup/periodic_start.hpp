// What the network of a run starts from (key time.start).
//   rest      the elements' own initial values
//   periodic  the periodic state of the case as a 0D network, the 3D root replaced by its surrogate, at the start
//             of a beat: y(0) = y(T). Every state and valve is taken over by name; the surrogate's own are dropped.
// The run's clock begins at 0, which is any multiple of the period for a network whose sources repeat; what
// happens once (pressurise_s) is past. mmHg, ml, s.
#pragma once

#include <string>

#include "common/comm.hpp"
#include "lumped/network/lumped_state.hpp"
#include "setup/case.hpp"

namespace valsalva::setup {

/// The network that the run integrates, and its state at t = 0.
struct NetworkStart {
  lumped::NetworkSpec spec;
  lumped::LumpedState state;
  double valve_load_mmHg = 0.0;  ///< aortic minus ventricular pressure at the start; 0 at rest
  std::string text;              ///< one line for the log; empty at rest
};

/// The start of `spec`, the network of a 3D or a 0D run of `c`. CaseError without time.period_s, with a source
/// that does not repeat, or if blood flows through a 3D root when the beat begins; SolverError if no periodic
/// state is found. Rank 0 computes: the others have its load, but neither its state, which they get from
/// coupling::Circulation, nor its text. Collective.
NetworkStart network_start(const Case& c, lumped::NetworkSpec spec, const Communicator& comm);

}  // namespace valsalva::setup
