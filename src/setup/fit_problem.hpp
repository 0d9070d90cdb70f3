// What `valsalva fit` fits to what: the case's free parameters, signals and targets with the measured data. Sources
// with a `column` but no `file` take their tables from the data.
#pragma once

#include "lumped/fit/fit_problem.hpp"
#include "setup/case.hpp"

namespace valsalva::setup {

/// `data_path` wins over fit.data. CaseError for a 3D case and for signals without data; IoError for the CSV.
lumped::FitProblem fit_problem(const Case& c, const std::string& data_path);

}  // namespace valsalva::setup
