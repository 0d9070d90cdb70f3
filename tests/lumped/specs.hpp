// Network specs for the tests, as the case reader would make them. mmHg, ml, s.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "lumped/integration/cvode_integrator.hpp"
#include "lumped/network/network.hpp"
#include "lumped/network/network_spec.hpp"

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

/// The network of cases/lumped_heart with a more ideal ventricle and aortic valve.
inline NetworkSpec left_heart()
{
  return {
      {pressure_source("veins", "la", 10.0), valve("mitral", "la", "lv", 0.005), chamber("ventricle", "lv"),
       valve("aortic", "lv", "ao", 0.012, 0.0003), windkessel("arteries", "ao", 0.033, 0.79, 1.75, 80.0)},
      {},
      0.8};
}

inline ElementSpec heart_chamber(const std::string& name, double Emax, double Emin, double V0, double volume,
                                 double onset = 0.0)
{
  ElementSpec e = chamber(name, name, volume);
  e.numbers["Emax_mmHg_ml"] = Emax;
  e.numbers["Emin_mmHg_ml"] = Emin;
  e.numbers["V0_ml"] = V0;
  e.numbers.erase("period_s");
  e.numbers["onset_periods"] = onset;
  if (onset > 0.0) {
    e.words["activation"] = "half_cosine";
    e.numbers["systole_periods"] = 0.2;
  }
  return e;
}

/// With a compliance at its inlet, if any.
inline ElementSpec vessel(const std::string& name, const std::string& from, const std::string& to, double R,
                          double L = 0.0, double C = 0.0, double initial = 0.0)
{
  return {name,
          "vessel",
          {{"from", from}, {"to", to}},
          {{"R_mmHg_s_ml", R}, {"L_mmHg_s2_ml", L}, {"C_ml_mmHg", C}, {"initial_pressure_mmHg", initial}},
          {},
          {{"wall", "inlet"}}};
}

/// The network of cases/four_chamber_loop without Bernoulli losses: twelve states, closed.
inline NetworkSpec four_chambers()
{
  return {
      {heart_chamber("lv", 2.5, 0.06, 10.0, 120.0), heart_chamber("rv", 0.55, 0.05, 20.0, 130.0),
       heart_chamber("la", 0.25, 0.15, 15.0, 60.0, 0.85), heart_chamber("ra", 0.22, 0.12, 15.0, 60.0, 0.85),
       valve("mitral", "la", "lv", 0.005), valve("aortic", "lv", "ao", 0.012, 0.0003),
       valve("tricuspid", "ra", "rv", 0.005), valve("pulmonary", "rv", "pa", 0.008, 0.0002),
       vessel("aorta", "ao", "sa", 0.03, 0.0005, 0.3, 85.0), vessel("body", "sa", "sv", 0.9, 0.0, 1.4, 85.0),
       vessel("veins", "sv", "ra", 0.02, 0.0, 60.0, 7.0), vessel("lungs", "pa", "pv", 0.08, 0.0, 4.5, 15.0),
       vessel("lung_veins", "pv", "la", 0.01, 0.0, 12.0, 9.0)},
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
