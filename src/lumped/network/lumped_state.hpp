// Everything a lumped network is at one instant; saving and restoring is copying this.
// In addition to the continuous states y (names and units: Network::states) a valve is open or closed, which the
// states alone do not tell.
#pragma once

#include <vector>

namespace valsalva::lumped {

template <class Scalar>
struct NetworkState {
  double t = 0.0;               ///< s
  std::vector<Scalar> y;        ///< mmHg, ml, ml/s as the state's unit says
  std::vector<int> valve_open;  ///< per valve, 1 open, 0 closed

  bool operator==(const NetworkState&) const = default;
};

using LumpedState = NetworkState<double>;

}  // namespace valsalva::lumped
