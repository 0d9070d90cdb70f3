// What a fit's data cannot tell, in sentences: parameters that no residual depends on, parameters of
// which only a combination is determined, wide intervals, near-collinear pairs, bounds, correlated residuals.
#pragma once

#include <string>
#include <vector>

#include "lumped/fit/fit.hpp"
#include "lumped/fit/fit_model.hpp"

namespace valsalva::lumped {

/// `unknowns` in the order of fit.estimates; empty where all is well.
std::vector<std::string> fit_flags(const Fit& fit, const std::vector<Unknown>& unknowns);

/// Sentences on data whose length is not that of the beat, of a periodic fit: signals, and tables of sources.
std::vector<std::string> data_flags(const FitProblem& problem);

/// The whole result as text: estimates with intervals, correlations, residuals, flags.
std::string fit_text(const Fit& fit);

}  // namespace valsalva::lumped
