// `valsalva fit`: the free parameters of a 0D case to a measured beat. Writes the files of fit_output.hpp.
#pragma once

#include <string>

#include "casefile/case_file.hpp"

namespace valsalva::run {

struct FitOptions {
  std::string data_path;  ///< CSV of the measured beat; empty: the case's fit.data
  std::string out_dir;
  bool force = false;  ///< replace what is in `out_dir`
};

/// Returns the exit code. Throws CaseError, SolverError, IoError. Collective.
int fit_case(const CaseFile& c, const FitOptions& options);

}  // namespace valsalva::run
