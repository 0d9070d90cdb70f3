// Network specs for the tests, as the case reader would make them. mmHg, ml, s.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "lumped/cvode_integrator.hpp"
#include "lumped/network.hpp"
#include "lumped/network_spec.hpp"

namespace valsalva::lumped::testing {

inline ElementSpec pressure_source(const std::string& name, const std::string& node, double p)
{
  return {name, "pressure_source", {{"node", node}}, {}, {{"pressure_mmHg", {p}}}, {}};
}

inline ElementSpec pressure_table(const std::string& name, const std::string& node, std::vector<double> t,
                                  std::vector<double> p)
{
  return {name,
          "pressure_source",
          {{"node", node}},
          {},
          {{"time_s", std::move(t)}, {"pressure_mmHg", std::move(p)}},
          {}};
}

inline ElementSpec flow_table(const std::string& name, const std::string& node, std::vector<double> t,
                              std::vector<double> Q)
{
  return {name, "flow_source", {{"node", node}}, {}, {{"time_s", std::move(t)}, {"flow_ml_s", std::move(Q)}},
          {}};
}

inline ElementSpec windkessel(const std::string& name, const std::string& node, double Rc = 0.033,
                              double Rp = 0.79, double C = 1.75, double initial = 85.0)
{
  return {name,
          "windkessel3",
          {{"node", node}},
          {{"Rc_mmHg_s_ml", Rc}, {"Rp_mmHg_s_ml", Rp}, {"C_ml_mmHg", C}, {"initial_pressure_mmHg", initial}},
          {},
          {}};
}

inline ElementSpec valve(const std::string& name, const std::string& from, const std::string& to, double R,
                         double L = 0.0, double B = 0.0)
{
  return {name,
          "valve",
          {{"from", from}, {"to", to}},
          {{"R_mmHg_s_ml", R}, {"L_mmHg_s2_ml", L}, {"B_mmHg_s2_ml2", B}},
          {},
          {}};
}

inline ElementSpec chamber(const std::string& name, const std::string& node, double initial_volume = 130.0)
{
  return {name,
          "chamber",
          {{"node", node}},
          {{"Emax_mmHg_ml", 2.4},
           {"Emin_mmHg_ml", 0.065},
           {"V0_ml", 12.0},
           {"period_s", 0.8},
           {"initial_volume_ml", initial_volume}},
          {},
          {}};
}

/// cases/lumped_heart/case.toml
inline NetworkSpec left_heart()
{
  return {
      {pressure_source("veins", "la", 10.0), valve("mitral", "la", "lv", 0.005), chamber("ventricle", "lv"),
       valve("aortic", "lv", "ao", 0.012, 0.0003), windkessel("arteries", "ao", 0.033, 0.79, 1.75, 80.0)},
      {},
      0.8};
}

/// cases/aortic_root/case.toml
inline NetworkSpec aortic_root()
{
  ElementSpec arteries = windkessel("arteries", "ao");
  arteries.numbers["pressurise_s"] = 0.05;
  return {{pressure_table("ventricle", "lv", {0.0, 0.05, 0.15, 0.35, 0.45, 0.8},
                          {0.0, 0.0, 120.0, 120.0, 0.0, 0.0}),
           arteries},
          {"lv", "ao"},
          0.0};
}

/// The value of an observable by its name.
inline double observed(const LumpedNetwork& network, const LumpedState& state, const std::string& name,
                       std::vector<double> Q = {})
{
  Q.resize(static_cast<std::size_t>(network.port_count()), 0.0);
  const std::vector<double> values = network.observe(state, Q);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (network.observables()[i].name == name) return values[i];
  throw std::logic_error("no observable " + name);
}

/// Where the increasing or decreasing continuous f changes its sign in [low, high].
inline double bisect(const std::function<double(double)>& f, double low, double high)
{
  const bool low_is_negative = f(low) < 0.0;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    ((f(middle) < 0.0) == low_is_negative ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// When the valve first is in another position than in `state`, by advancing again and again from there.
inline double switching_time(CvodeIntegrator& integrator, const LumpedState& state, double latest)
{
  const auto still_the_same = [&](double t) {
    LumpedState s = state;
    integrator.advance(s, t, {}, {});
    return s.valve_open == state.valve_open ? -1.0 : 1.0;
  };
  return bisect(still_the_same, state.t, latest);
}

}  // namespace valsalva::lumped::testing
