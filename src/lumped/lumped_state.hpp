// Everything a lumped network remembers: saving and restoring is copying this.
// Besides the continuous states y (names and units: LumpedNetwork::states) a valve is open or closed, which
// the states alone do not tell.
#pragma once

#include <vector>

namespace valsalva::lumped {

struct LumpedState {
  double t = 0.0;               ///< s
  std::vector<double> y;        ///< mmHg, ml, ml/s as the state's unit says
  std::vector<int> valve_open;  ///< per valve, 1 open, 0 closed

  bool operator==(const LumpedState&) const = default;
};

}  // namespace valsalva::lumped
