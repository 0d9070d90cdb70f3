// `valsalva fit`: the free parameters of a 0D case to a measured beat. Writes the files of fit_output.hpp.
#pragma once

#include <string>

#include "common/comm.hpp"
#include "setup/case.hpp"

namespace valsalva::run {

struct FitOptions {
  std::string data_path;  ///< CSV of the measured beat; empty: the case's fit.data
  std::string out_dir;
  bool force = false;  ///< replace what is in `out_dir`
};

/// Returns the exit code. Throws CaseError, SolverError, IoError. Collective.
int fit_case(const setup::Case& c, const FitOptions& options, const Communicator& comm);

}  // namespace valsalva::run
