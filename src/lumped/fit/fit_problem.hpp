// What is to be fitted to what: plain data. mmHg, ml, s.
//   parameters   numbers of elements ("arteries.Rp_mmHg_s_ml") that are free within bounds
//   signals      measured traces of an observable of the network over one beat
//   summaries    single numbers of the beat, as they are read off a cuff or an echo
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "lumped/network/network_spec.hpp"

namespace valsalva::lumped {

/// A number of an element that is free between its bounds.
struct FitParameter {
  std::string name;
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
};

/// A measured trace; in the unit of its observable.
struct FitSignal {
  std::string name;
  std::string observable;        ///< "p_ao_mmHg"
  std::vector<double> t, value;  ///< t from 0, increasing
  double sd = 0.0;               ///< of the measurement; 0: unknown, estimated from the residuals
  bool has_baseline = false;     ///< the data are the model plus an unknown constant
  bool has_shift = false;        ///< the data lag the model by an unknown time
};

enum class SummaryKind { systolic, diastolic, mean, volume };  ///< largest, smallest, mean, time integral

/// A measured number; in the unit of its observable, a volume in ml.
struct FitSummary {
  std::string name;
  SummaryKind kind;
  std::string observable;
  double value;
  double sd;
};

struct FitProblem {
  NetworkSpec network;  ///< its values are the start of the search
  std::vector<FitParameter> parameters;
  std::vector<FitSignal> signals;
  std::vector<FitSummary> summaries;
  bool periodic = true;  ///< the data are a beat of the periodic state; else they start at the initial state
  double rtol = 1e-9;
};

}  // namespace valsalva::lumped
