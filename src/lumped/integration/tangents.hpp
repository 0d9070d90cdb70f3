// How a network's behaviour changes along K directions: the right-hand side of its forward sensitivities. With
// S = dy/dp, y' = g(t, y, p),
//     S' = (dg/dy) S + dg/dp
// evaluated exactly by networks of duals, kLanes directions at a time. A direction is a parameter of an
// element ("arteries.Rp_mmHg_s_ml"; the one value of a constant source too) or a state ("arteries.Pc_mmHg"),
// which stands for its value at the start. S has one row per state and one column per direction.
//   At a switching valve    S+ = d(reset)/dy S- : a flow that is set to zero keeps no sensitivity. Nothing
//                           more, since y' does not jump except in that flow.
//   At a kink at tau(p)     S+ = S- + (g- - g+) dtau/dp.
// Source: Hindmarsh et al., User documentation for CVODES; Galan, Feehery & Barton, Appl Numer Math 31 (1999)
// 17-47.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lumped/network/network.hpp"

namespace valsalva::lumped {

class Tangents {
 public:
  /// CaseError for a name that is neither a parameter nor a state, with the nearest one.
  Tangents(const NetworkSpec& spec, std::vector<std::string> directions);

  int count() const { return static_cast<int>(directions_.size()); }
  const std::vector<std::string>& directions() const { return directions_; }
  /// The size of each direction's quantity, for tolerances; 1 for a state or a zero.
  const std::vector<double>& scales() const { return scales_; }

  /// S at the start: dy(0)/dp.
  Eigen::MatrixXd initial() const;
  /// S' along all directions; `S` and `dSdt` point to one array per direction.
  void rates(Instant now, const double* y, std::span<const int> valve_open, const double* const* S,
             double* const* dSdt);
  /// `state` is as the switching of this valve has left it.
  void follow_switch(int valve, const LumpedState& state, Eigen::MatrixXd& S) const;
  /// `state` stands on the kink that came next after `t_before`; `t_after` is within the next piece.
  void follow_kink(double t_before, double t_after, const LumpedState& state, Eigen::MatrixXd& S);
  /// Derivatives of Network::observe, one row per observable.
  Eigen::MatrixXd observe(const LumpedState& state, const Eigen::MatrixXd& S) const;
  /// Derivatives of Network::volume.
  Eigen::RowVectorXd volume(const LumpedState& state, const Eigen::MatrixXd& S) const;

 private:
  /// Up to kLanes directions.
  struct Bundle {
    std::unique_ptr<Network<Dual>> network;
    NodalCircuit<Dual> circuit;
    Eigen::Index first, count;
  };
  NetworkState<Dual> dual_state(const Bundle& bundle, const LumpedState& state,
                                const Eigen::MatrixXd& S) const;

  std::vector<std::string> directions_;
  std::vector<double> scales_;
  std::vector<Bundle> bundles_;
  Eigen::Index observable_count_ = 0;
  std::vector<double> no_flow_;  ///< through the ports
  std::vector<Dual> y_, rates_;
};

/// The number that a direction stands for: a parameter, completed by its default. CaseError as above.
double& parameter_of(NetworkSpec& spec, const std::string& name);

}  // namespace valsalva::lumped
