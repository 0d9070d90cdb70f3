// A prescribed signal: a constant, a Fourier series, or a piecewise-linear table of (time, value).
//   series   constant + sum_k a_k cos(2 pi k t/T) + b_k sin(2 pi k t/T),   k = 1, 2, ...
//   hold     before the first time of a table its value, after the last time the last value
//   repeat   the table repeated every T; a gap between its end and the next beginning is bridged linearly
// T is the heart period. Times in s; the unit of the values is the owner's.
#pragma once

#include <vector>

#include "lumped/network/element_types.hpp"

namespace valsalva::lumped {

template <class Scalar>
class Waveform {
 public:
  /// From the keys <value>, time_s, beyond_table, cosine and sine of a checked source.
  Waveform(const ElementInput<Scalar>& input, const std::string& value_key);

  /// In the unit of the values.
  Scalar value(Instant now) const;
  /// The smallest time more than kTimeResolution_s after t (s) at which a table has a corner; infinity if none.
  Scalar next_kink(double t) const;

 private:
  Scalar series(double t) const;

  std::vector<double> times_;
  std::vector<Scalar> values_;
  std::vector<double> cosine_, sine_;
  double heart_period_;
  double repeat_period_;  ///< 0: hold
};

/// The keys of a source: `<value_key>` (constant or table), time_s, beyond_table, cosine_<unit>, sine_<unit>,
/// file and column.
std::vector<ElementParameter> waveform_parameters(const std::string& value_key, const std::string& unit,
                                                  const std::string& quantity, const std::string& meaning);
/// Adds what is wrong with the keys together: tables of unequal length, times that do not increase, a repeat without a
/// period.
void check_waveform(const ElementSpec& element, const std::string& value_key, double period_s,
                    std::vector<CaseProblem>& problems);

}  // namespace valsalva::lumped
