// The implicit closure between the flows of the 3D side and the pressures of the 0D side.
#include "coupling/circulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "common/error.hpp"
#include "lumped/specs.hpp"

namespace valsalva::coupling {

namespace {

using namespace lumped::testing;

const Communicator kAlone(MPI_COMM_SELF);

constexpr double kDt = 2e-3;

/// Response of a closed domain with inertance L between two openings.
Eigen::Matrix2d response(double L)
{
  Eigen::Matrix2d G;
  G << 1, -1, -1, 1;
  return kDt / L * G;
}

TEST(Circulation, ClosureWithWindkesselAndSourceIsTheClosedForm)
{
  const double Rc = 0.033, Rp = 0.79, C = 1.75, Pc = 85;
  Circulation circulation(
      {{pressure_table("ventricle", "lv", {0, 0.1}, {80, 120}), windkessel("arteries", "ao", Rc, Rp, C, Pc)},
       {"lv", "ao"},
       0.0},
      kAlone);
  const std::vector<double> Q{-50, 50};
  const Eigen::Vector2d Q0(-190, 190), p_used(100, 90);
  const Eigen::Matrix2d G = response(0.003);
  const Eigen::VectorXd phi = circulation.close(kDt, Q, Q0, G, p_used);

  // design: lumped, section 5; the pressures are means over the step.
  const double tau = Rp * C, e = std::exp(-kDt / tau), g = 1 - (1 - e) * tau / kDt;
  const double B = Rc + Rp * g, alpha = e * Pc + Rp * ((1 - e) - g) * Q[1];
  const Eigen::Vector2d constant(0.5 * (80 + 80 + 400 * kDt), 0.5 * (Pc + Rc * Q[1] + alpha));
  Eigen::Matrix2d slope = Eigen::Matrix2d::Zero();
  slope(1, 1) = 0.5 * B;
  const Eigen::Vector2d exact =
      (Eigen::Matrix2d::Identity() + slope * G).lu().solve(constant + slope * Q0 - p_used);
  EXPECT_NEAR(phi[0], exact[0], 1e-7);
  EXPECT_NEAR(phi[1], exact[1], 1e-7);
}

void expect_closed(Circulation& circulation, const std::vector<double>& Q, const Eigen::VectorXd& Q0,
                   const Eigen::MatrixXd& G)
{
  const Eigen::VectorXd p_used = Eigen::VectorXd::Constant(Q0.size(), 90);
  const Eigen::VectorXd phi = circulation.close(kDt, Q, Q0, G, p_used);
  const Eigen::VectorXd p = circulation.mean_pressures(kDt, Q, Q0 - G * phi);
  EXPECT_LT((p_used + phi - p).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(), 1e-8);
}

TEST(Circulation, ClosureHoldsWithAVentricleAndAMitralValveThatShutsInTheStep)
{
  // The outflow tract is the port; the ventricle's pressure is near the atrium's, so that the sign of the
  // mitral flow depends on the flow taken out.
  for (const double flow : {-200.0, -20.0, 0.0, 20.0, 200.0}) {
    Circulation circulation({{pressure_source("veins", "la", 8), valve("mitral", "la", "lv", 0.005),
                              chamber("ventricle", "lv", 135), windkessel("arteries", "ao")},
                             {"lv", "ao"},
                             0.8},
                            kAlone);
    for (int n = 0; n < 20; ++n) {
      expect_closed(circulation, {flow, -flow}, Eigen::Vector2d(flow, -flow), response(0.003));
      circulation.advance(kDt, {flow, -flow}, {flow, -flow});
    }
  }
}

TEST(Circulation, AskingForPressuresChangesNothing)
{
  Circulation circulation(lumped::testing::aortic_root(), kAlone);
  circulation.advance(0.06, {0, 0}, {-30, 30});
  const lumped::LumpedState before = circulation.state();
  circulation.mean_pressures(kDt, {-30, 30}, Eigen::Vector2d(-60, 60));
  circulation.close(kDt, {-30, 30}, Eigen::Vector2d(-60, 60), response(0.003), Eigen::Vector2d(0, 0));
  EXPECT_EQ(circulation.state(), before);
}

TEST(Circulation, APressureThatIsNoNumberDoesNotCountAsConvergence)
{
  Circulation circulation(lumped::testing::aortic_root(), kAlone);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(
      circulation.close(kDt, {0, 0}, Eigen::Vector2d(-30, 30), response(0.003), Eigen::Vector2d(0, nan)),
      SolverError);
}

}  // namespace
}  // namespace valsalva::coupling
