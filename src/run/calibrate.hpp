// `valsalva calibrate`: the 0D surrogate of the root from a 3D run. The pressures that the run had at its two
// openings drive the surrogate of its case over one beat, from rest; open orifice, closing rate and inertance
// are found by least squares on the flow through the outlet, taken every millisecond. Writes the files of
// fit_output.hpp and surrogate.toml: the run's case with the calibrated [surrogate].
#pragma once

#include <string>

#include "common/comm.hpp"
#include "common/time_series.hpp"
#include "lumped/fit/fit_problem.hpp"
#include "setup/case.hpp"

namespace valsalva::run {

struct CalibrateOptions {
  std::string run_dir;  ///< output folder of the 3D run
  std::string out_dir;
  int beat = 1;
  bool force = false;  ///< replace what is in `out_dir`
};

/// What is fitted to what, from the run's openings.csv. CaseError if `openings` does not reach into the beat or
/// the case has not one opening at each end; IoError for a missing column.
lumped::FitProblem calibration_problem(const setup::Case& c, const TimeSeries& openings, int beat);

/// `c` is the run's resolved case. Returns the exit code. CaseError, SolverError, IoError. Collective.
int calibrate(const setup::Case& c, const CalibrateOptions& options, const Communicator& comm);

}  // namespace valsalva::run
