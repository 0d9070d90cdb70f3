// The 0D surrogate of a 3D root: built from a case, found again from its own traces, and as the start of a run.
#include "setup/surrogate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "complaint.hpp"
#include "coupling/small_cases.hpp"
#include "lumped/fit/fit.hpp"
#include "lumped/integration/limit_cycle.hpp"
#include "run/calibrate.hpp"
#include "setup/build_model.hpp"

namespace valsalva::setup {

using namespace coupling;
using namespace run;
namespace {

/// The ventricle beats, into arteries that are filled at the start.
Changes beating(const Changes& more)
{
  Changes all{"element.ventricle.time_s=[0.0, 0.05, 0.15, 0.35, 0.45, 0.8]",
              "element.ventricle.pressure_mmHg=[0.0, 0.0, 120.0, 120.0, 0.0, 0.0]",
              "element.ventricle.beyond_table=repeat", "element.arteries.initial_pressure_mmHg=60",
              "element.arteries.pressurise_s=0.05"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

Case root_case(const Changes& changes = {}, const std::string& more = "")
{
  return tube_case(beating(changes), more);
}

/// openings.csv of a root that is the surrogate itself: pressures of a beat, linear between the milliseconds.
TimeSeries traces_of(const lumped::ElementSpec& root)
{
  TimeSeries traces{{"t_s", "p_lv_mmHg", "p_ao_mmHg", "Q_outlet_ml_s"}, std::vector<std::vector<double>>(4)};
  for (int n = 0; n <= 800; ++n) {
    const double t = 1e-3 * n, systole = std::sin(std::numbers::pi * (t - 0.1) / 0.3);
    traces.columns[0].push_back(t);
    traces.columns[1].push_back(t > 0.1 && t < 0.4 ? 125.0 * systole : 0.0);
    traces.columns[2].push_back(
        85.0 + (t > 0.15 && t < 0.45 ? 20.0 * std::sin(std::numbers::pi * (t - 0.15) / 0.3) : 0.0));
    traces.columns[3].push_back(0.0);
  }
  lumped::NetworkSpec spec = calibration_problem(root_case(), traces, 1).network;
  spec.elements.back() = root;
  const lumped::LumpedNetwork network(spec);
  lumped::CvodeIntegrator integrator(network, 1e-11);
  lumped::LumpedState state = network.initial_state();
  for (std::size_t n = 1; n <= 800; ++n) {
    integrator.advance(state, traces.columns[0][n], {}, {});
    traces.columns[3][n] = state.y[0];
  }
  return traces;
}

TEST(Calibration, FindsTheSurrogateThatMadeTheTraces)
{
  const std::vector<std::pair<std::string, double>> truth{
      {"area_open_cm2", 2.4}, {"closing_1_mmHg_s", 4.5}, {"L_mmHg_s2_ml", 0.0034}};
  lumped::ElementSpec root = surrogate_element(root_case());
  for (const auto& [key, value] : truth) root.numbers[key] = value;
  const lumped::Fit fit = lumped::fit(calibration_problem(root_case(), traces_of(root), 1));
  EXPECT_TRUE(fit.converged);
  ASSERT_EQ(fit.estimates.size(), truth.size());
  for (std::size_t k = 0; k < truth.size(); ++k) {
    EXPECT_EQ(fit.estimates[k].name, "aortic_root." + truth[k].first);
    EXPECT_NEAR(fit.estimates[k].value / truth[k].second, 1.0, 1e-6) << truth[k].first;
  }
}

TEST(Calibration, ABeatThatTheRunHasNotReachedIsRefused)
{
  const TimeSeries traces = traces_of(surrogate_element(root_case()));
  EXPECT_NE(complaint([&] {
              calibration_problem(root_case(), traces, 2);
            }).find("--beat: is 2, but the run ends at t = 0.8 s"),
            std::string::npos);
}

TEST(Surrogate, ItsNetworkIsThatOfAHandWrittenCase)
{
  const Case written = circulation_case(beating({}), R"(
[[element]]
name = "aortic_root"
type = "orifice_valve"
from = "lv"
to = "ao"
area_open_cm2 = 2.5
area_closed_cm2 = 0.002
length_cm = 1.5
opening_1_mmHg_s = 30.0
closing_1_mmHg_s = 5.0
R_mmHg_s_ml = 0.001
L_mmHg_s2_ml = 0.002
density_g_cm3 = 1.05
)");
  const Case in_3d =
      root_case({"surrogate.area_open_cm2=2.5", "surrogate.area_closed_cm2=0.002", "surrogate.length_cm=1.5",
                 "surrogate.opening_1_mmHg_s=30", "surrogate.closing_1_mmHg_s=5",
                 "surrogate.R_mmHg_s_ml=0.001", "surrogate.L_mmHg_s2_ml=0.002", "fluid.density_g_cm3=1.05"});
  const auto state_of = [](const Case& c) {
    const lumped::LumpedNetwork network(lumped_network(c));
    lumped::CvodeIntegrator integrator(network);
    lumped::LumpedState state = network.initial_state();
    integrator.advance(state, 0.3, {}, {});
    return state;
  };
  EXPECT_GT(state_of(in_3d).y[1], 100.0);
  EXPECT_EQ(state_of(in_3d), state_of(written));
}

TEST(Surrogate, NeedsOneOpeningAtEachEnd)
{
  const std::string second =
      "[[opening]]\nname = \"second\"\nside = \"z_hi\"\ncenter_cm = [0.15, 0.15]\nradius_cm = 0.1\nport = "
      "\"ao\"\n";
  const auto both_on = [](const std::string& moved) {
    return root_case({moved, "opening.inlet.radius_cm=0.2", "opening.outlet.radius_cm=0.2",
                      "opening.outlet.center_cm=[1.6, 1.6]"});
  };
  for (const Case& c : {both_on("opening.outlet.side=z_lo"), both_on("opening.inlet.side=z_hi"),
                        root_case({}, second), circulation_case({}, second)})
    EXPECT_NE(complaint([&] { lumped_network(c); }).find("one opening on z_lo to one on z_hi"),
              std::string::npos);
}

TEST(PeriodicStart, A3DRunBeginsInTheStateOfItsTwin)
{
  Timers timers;
  CaseModel model(root_case({"time.start=periodic"}), Communicator(MPI_COMM_SELF), timers);
  lumped::NetworkSpec twin = lumped_network(root_case());
  twin.elements[1].numbers["pressurise_s"] = 0.0;
  const lumped::LimitCycle cycle = lumped::find_limit_cycle(twin);
  const double Pc = cycle.start.y[0];
  EXPECT_GT(Pc, 65.0);
  EXPECT_EQ(model.model().t(), 0.0);
  EXPECT_NEAR(model.circulation().state().y[0], Pc, 1e-6);
  // Past its ramp, the Windkessel's pressure stands at the outlet from the first instant.
  EXPECT_NEAR(model.model().interface().pressure_mmHg[1], Pc, 1e-6);
  EXPECT_NEAR(model.start().valve_load_mmHg, Pc, 0.1);
  EXPECT_NE(model.start().text.find("stroke volume"), std::string::npos);
}

TEST(PeriodicStart, WhatHasNoPeriodicBeginningInDiastoleIsRefused)
{
  const auto start = [](Changes changes) {
    changes.emplace_back("time.start=periodic");
    const Case c = root_case(changes);
    network_start(c, c.network, Communicator(MPI_COMM_SELF));
  };
  EXPECT_NE(complaint([&] { start({"time.period_s=0"}); }).find("time.period_s is 0; set it"),
            std::string::npos);
  EXPECT_NE(complaint([&] {
              start({"element.ventricle.beyond_table=hold"});
            }).find("use beyond_table = \"repeat\""),
            std::string::npos);
  EXPECT_NE(complaint([&] {
              start({"element.ventricle.time_s=[0.0, 0.2, 0.4, 0.6]",
                     "element.ventricle.pressure_mmHg=[120,0,0,120]"});
            }).find("shift the sources"),
            std::string::npos);
}

}  // namespace
}  // namespace valsalva::setup
