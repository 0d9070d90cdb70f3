// The periodic state of a network, by Newton shooting. With the flow map y0 -> y(T; y0, p), its monodromy matrix
// Phi = dy(T)/dy0 and S_p = dy(T)/dp,
//     (I - Phi) d = y(T) - y0,   y0 <- y0 + d              d y0/dp = (I - Phi)^{-1} S_p.
// A closed loop keeps its volume V, so that Phi has the eigenvalue 1; there the row
//     (dV/dy) d = V(start) - V(y0)
// is added and the overdetermined, consistent system solved by least squares: of all periodic states the one
// with the volume of the network's initial state. Marching takes tens of beats, Newton two to four steps.
// Source: Seydel, Practical Bifurcation and Stability Analysis, Springer 2010, chapter 7. mmHg, ml, s.
#pragma once

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "lumped/integration/cvode_integrator.hpp"

namespace valsalva::lumped {

/// A periodic state and how it depends on its start and on the parameters.
struct LimitCycle {
  LumpedState start;          ///< at a multiple of the period, after all that happens once
  Eigen::MatrixXd S;          ///< d start.y/dp, one column per parameter
  Eigen::MatrixXd monodromy;  ///< Phi
  int newton_steps = 0;
  double residual = 0.0;  ///< largest |y(T) - y0|/(1 + |y0|)
};

struct LimitCycleOptions {
  double rtol = 1e-8;    ///< of the integration and of the periodicity
  int beats_before = 2;  ///< marched from the initial state before the first Newton step
  int most_steps = 20;
};

/// `spec` must name its period; `parameters` as directions of Tangents. `guess`, if given, is used instead of
/// marching. SolverError if Newton does not converge.
LimitCycle find_limit_cycle(const NetworkSpec& spec, const std::vector<std::string>& parameters = {},
                            const LimitCycleOptions& options = {}, const LumpedState* guess = nullptr);

/// One beat of the periodic state: observables at given times, with their derivatives.
struct SampledBeat {
  std::vector<LumpedState> states;         ///< at the times
  Eigen::MatrixXd values;                  ///< time x observable
  Eigen::MatrixXd slopes;                  ///< their time derivatives, to about six digits
  std::vector<Eigen::MatrixXd> gradients;  ///< per observable: time x parameter
  Eigen::VectorXd integrals;               ///< over the whole period, per observable
  Eigen::MatrixXd integral_gradients;      ///< observable x parameter
};

/// `times` increasing, from 0; beyond the period the integrals continue to the last; `observables` by name ("p_ao_mmHg", "Q_aortic_ml_s").
SampledBeat sample_beat(const NetworkSpec& spec, const LimitCycle& cycle,
                        const std::vector<std::string>& parameters,
                        const std::vector<std::string>& observables, const std::vector<double>& times,
                        double rtol = 1e-8);

}  // namespace valsalva::lumped
