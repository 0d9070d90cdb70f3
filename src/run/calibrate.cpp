#include "run/calibrate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "common/error.hpp"
#include "common/log.hpp"
#include "common/output_folder.hpp"
#include "common/text_file.hpp"
#include "lumped/fit/fit.hpp"
#include "run/fit_output.hpp"
#include "setup/surrogate.hpp"

namespace valsalva::run {

namespace {

constexpr double kSampleInterval_s = 1e-3;
constexpr double kTolerance = 1e-6;  // every sample is a kink of the pressures, where the integrator restarts
constexpr double kShortest_s = 0.05;  ///< of a beat to learn anything from

/// Linear between the rows; `t` increasing.
std::vector<double> interpolate(const std::vector<double>& t, const std::vector<double>& value,
                                const std::vector<double>& at)
{
  std::vector<double> values;
  std::size_t after = 1;
  for (double time : at) {
    while (after + 1 < t.size() && t[after] < time) ++after;
    const double share = (time - t[after - 1]) / (t[after] - t[after - 1]);
    values.push_back(value[after - 1] + share * (value[after] - value[after - 1]));
  }
  return values;
}

lumped::ElementSpec pressure_source(const std::string& name, const std::string& node,
                                    const std::vector<double>& t, const std::vector<double>& p_mmHg)
{
  return {name, "pressure_source", {{"node", node}}, {}, {{"time_s", t}, {"pressure_mmHg", p_mmHg}}, {}};
}

/// The run's case with the fitted numbers, each with its standard deviation.
std::string surrogate_toml(const setup::Case& c, const lumped::Fit& fit, const CalibrateOptions& options)
{
  std::string text = fmt::format(
      "# The 0D surrogate of the 3D root, from beat {} of {}: flow to {:.3g} ml/s (rms).\n"
      "# Run it: valsalva run --lumped THIS_FILE. Or paste the section into another case.\n"
      "extends = \"{}\"\n\n[surrogate]\n",
      options.beat, options.run_dir, fit.signals.front().rms,
      std::filesystem::absolute(c.source.path()).string());
  const lumped::ElementSpec& root = fit.network.elements.back();
  for (const auto& [key, initial] : c.surrogate) {
    text += fmt::format("{} = {:.6g}", key, root.numbers.at(key));
    for (const lumped::Estimate& e : fit.estimates)
      if (e.name == root.name + "." + key) text += fmt::format("   # sd {:.2g}", e.sd);
    text += '\n';
  }
  return text;
}

}  // namespace

lumped::FitProblem calibration_problem(const setup::Case& c, const TimeSeries& openings, int beat)
{
  const setup::RootPorts ports = setup::root_ports(c);
  const double period = c.time.beat_s();
  const std::vector<double>& t = openings.column("t_s");
  const double begin = (beat - 1) * period, end = std::min(beat * period, t.empty() ? 0.0 : t.back());
  if (beat < 1 || end - begin < kShortest_s)
    throw CaseError(
        "--beat",
        fmt::format("is {}, but the run ends at t = {:.4g} s and its beats are {:.4g} s long; choose "
                    "a beat from 1 on of which it has at least {} s",
                    beat, t.empty() ? 0.0 : t.back(), period, kShortest_s));
  const long intervals = std::lround((end - begin) / kSampleInterval_s);
  std::vector<double> in_run, in_beat;
  for (long n = 0; n <= intervals; ++n) {
    in_beat.push_back((end - begin) * static_cast<double>(n) / static_cast<double>(intervals));
    in_run.push_back(begin + in_beat.back());
  }
  const auto trace = [&](const std::string& column) {
    return interpolate(t, openings.column(column), in_run);
  };

  lumped::FitProblem problem;
  problem.periodic = false;
  problem.rtol = kTolerance;
  problem.network.period_s = period;
  problem.network.elements = {
      pressure_source("inlet", ports.inlet_node, in_beat, trace("p_" + ports.inlet_node + "_mmHg")),
      pressure_source("outlet", ports.outlet_node, in_beat, trace("p_" + ports.outlet_node + "_mmHg")),
      setup::surrogate_element(c)};
  const std::string root = setup::kSurrogateName;
  problem.parameters = {{root + ".area_open_cm2", 0.05, 20.0},
                        {root + ".closing_1_mmHg_s", 0.1, 200.0},
                        {root + ".L_mmHg_s2_ml", 1e-4, 0.1}};
  const std::string flow = "Q_" + ports.outlet + "_ml_s";
  problem.signals.push_back({flow, "Q_" + root + "_ml_s", in_beat, trace(flow)});
  return problem;
}

int calibrate(const setup::Case& c, const CalibrateOptions& options, const Communicator& comm)
{
  const lumped::FitProblem problem =
      calibration_problem(c, common::read_time_series(options.run_dir + "/openings.csv"), options.beat);
  // On every rank, with the same result: a problem that is refused then leaves no folder behind.
  const lumped::Fit fit = lumped::fit(problem);
  common::create_output_folder(options.out_dir, options.force, c.source.resolved_toml(), comm);
  if (!comm.is_rank_0()) return 0;
  const std::string text = write_fit(options.out_dir, fit);
  common::write_text_file(options.out_dir + "/surrogate.toml", surrogate_toml(c, fit, options));
  Log log(true, options.out_dir + "/log.txt");
  log.line(
      fmt::format("Surrogate of the 3D root from beat {} of {}\n\n{}", options.beat, options.run_dir, text));
  log.line("results in " + options.out_dir + "; run it with\nvalsalva run --lumped " + options.out_dir +
           "/surrogate.toml");
  log.check();
  return 0;
}

}  // namespace valsalva::run
