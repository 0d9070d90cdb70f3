// A prescribed signal: a constant, or a piecewise-linear table of (time, value).
//   hold     before the first time its value, after the last time the last value
//   repeat   the table repeated every `period`; a gap between its end and the next beginning is bridged
//   linearly
// Times in s; the unit of the values is the owner's.
#pragma once

#include <vector>

#include "lumped/element.hpp"
#include "lumped/element_types.hpp"

namespace valsalva::lumped {

class Waveform {
 public:
  /// `times` strictly increasing and as many as `values`, or one value alone; period 0: hold.
  Waveform(std::vector<double> times, std::vector<double> values, double period);

  double value(Instant now) const;
  double next_kink(double t) const;

 private:
  std::vector<double> times_, values_;
  double period_;
};

/// The keys `<value>` (constant or table), time_s and beyond_table of a source.
std::vector<ElementParameter> waveform_parameters(const std::string& value_key, const std::string& unit,
                                                  const std::string& quantity, const std::string& meaning);
void check_waveform(const ElementSpec& element, const std::string& value_key, double period_s,
                    std::vector<CaseProblem>& problems);
Waveform read_waveform(const ElementSpec& element, const std::string& value_key, double period_s);

}  // namespace valsalva::lumped
