// The files of a fit, of `valsalva fit` and `valsalva calibrate` alike:
//   fit.txt   the result for people        fit.json   the same for programs
//   fit.csv   t_s and, per signal, data, model and residual
#pragma once

#include <string>

#include "lumped/fit/fit.hpp"

namespace valsalva::run {

/// Writes them into an existing folder and returns the text of fit.txt. IoError.
std::string write_fit(const std::string& folder, const lumped::Fit& fit);

}  // namespace valsalva::run
