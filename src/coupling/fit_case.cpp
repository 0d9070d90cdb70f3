#include "coupling/fit_case.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "common/comm.hpp"
#include "common/error.hpp"
#include "common/log.hpp"
#include "common/output_folder.hpp"
#include "common/time_series.hpp"
#include "coupling/network_from_case.hpp"
#include "lumped/fit.hpp"
#include "lumped/fit_flags.hpp"

namespace valsalva::coupling {

namespace {

std::string data_path(const CaseFile& c, const FitOptions& options)
{
  if (!options.data_path.empty()) return options.data_path;
  const std::string& in_case = c.section("fit").text("data");
  return in_case.empty() ? "" : (std::filesystem::path(c.folder()) / in_case).string();
}

lumped::SummaryKind kind_of(const std::string& word)
{
  if (word == "systolic") return lumped::SummaryKind::systolic;
  if (word == "diastolic") return lumped::SummaryKind::diastolic;
  return word == "mean" ? lumped::SummaryKind::mean : lumped::SummaryKind::volume;
}

lumped::FitProblem problem_from_case(const CaseFile& c, const std::string& path)
{
  lumped::FitProblem problem;
  problem.network = network_from_case(c, path);
  problem.periodic = c.section("fit").flag("periodic");
  for (const CaseTable& t : c.tables("fit_parameter")) {
    lumped::FitParameter p{t.text("parameter")};
    if (t.has("lowest")) p.lowest = t.real("lowest");
    if (t.has("highest")) p.highest = t.real("highest");
    problem.parameters.push_back(p);
  }
  for (const CaseTable& t : c.tables("fit_signal")) {
    if (path.empty())
      throw CaseError(
          {t.problem("name", "needs measured data; give --data beat.csv, or fit.data in the case")});
    const TimeSeries data = common::read_time_series(path);
    lumped::FitSignal signal{t.text("name"), t.text("observable"), data.column("t_s"),
                             data.column(t.text("name"))};
    if (t.has("sd")) signal.sd = t.real("sd");
    signal.has_baseline = t.flag("baseline");
    signal.has_shift = t.flag("shift");
    problem.signals.push_back(std::move(signal));
  }
  for (const CaseTable& t : c.tables("fit_target"))
    problem.summaries.push_back(
        {t.text("name"), kind_of(t.text("kind")), t.text("observable"), t.real("value"), t.real("sd")});
  return problem;
}

/// JSON has no infinity.
std::string json_number(double value)
{
  return std::isfinite(value) ? fmt::format("{:.9g}", value) : "null";
}

std::string json_quoted(const std::string& text)
{
  std::string quoted = "\"";
  for (char character : text) {
    if (character == '"' || character == '\\') quoted += '\\';
    quoted += character;
  }
  return quoted + '"';
}

std::string fit_json(const lumped::Fit& fit)
{
  std::vector<std::string> estimates, rows, qualities, flags;
  for (const lumped::Estimate& e : fit.estimates)
    estimates.push_back(
        fmt::format("    {{\"name\": {}, \"start\": {}, \"value\": {}, \"sd\": {}, \"interval_95\": [{}, "
                    "{}], \"at_bound\": {}}}",
                    json_quoted(e.name), json_number(e.start), json_number(e.value), json_number(e.sd),
                    json_number(e.lowest), json_number(e.highest), e.at_bound));
  for (Eigen::Index a = 0; a < fit.correlation.rows(); ++a) {
    std::vector<std::string> row;
    for (Eigen::Index b = 0; b < fit.correlation.cols(); ++b)
      row.push_back(json_number(fit.correlation(a, b)));
    rows.push_back(fmt::format("    [{}]", fmt::join(row, ", ")));
  }
  for (const lumped::FitQuality& q : fit.signals)
    qualities.push_back(
        fmt::format("    {{\"name\": {}, \"samples\": {}, \"rms\": {}, \"lag_one_correlation\": {}}}",
                    json_quoted(q.name), q.data.size(), json_number(q.rms), json_number(q.lag_one)));
  for (const lumped::FitQuality& q : fit.summaries)
    qualities.push_back(fmt::format("    {{\"name\": {}, \"data\": {}, \"model\": {}}}", json_quoted(q.name),
                                    json_number(q.data.front()), json_number(q.model.front())));
  for (const std::string& flag : fit.flags) flags.push_back("    " + json_quoted(flag));
  return fmt::format(
      "{{\n  \"estimates\": [\n{}\n  ],\n  \"correlation\": [\n{}\n  ],\n  \"residuals\": [\n{}\n  ],\n"
      "  \"rank\": {},\n  \"condition\": {},\n  \"chi_squared\": {},\n  \"residual_count\": {},\n"
      "  \"evaluations\": {},\n  \"converged\": {},\n  \"flags\": [\n{}\n  ]\n}}\n",
      fmt::join(estimates, ",\n"), fmt::join(rows, ",\n"), fmt::join(qualities, ",\n"), fit.rank,
      json_number(fit.condition), json_number(fit.chi_squared), fit.residual_count, fit.evaluations,
      fit.converged, fmt::join(flags, ",\n"));
}

/// All signals come from one CSV, so that they share their times.
void write_traces(const std::string& path, const lumped::Fit& fit)
{
  std::vector<std::string> columns{"t_s"};
  for (const lumped::FitQuality& q : fit.signals)
    for (const char* what : {"data_", "model_", "residual_"}) columns.push_back(what + q.name);
  TimeSeriesWriter writer(path, columns);
  if (fit.signals.empty()) return;
  for (std::size_t n = 0; n < fit.signals.front().t.size(); ++n) {
    std::vector<double> row{fit.signals.front().t[n]};
    for (const lumped::FitQuality& q : fit.signals)
      row.insert(row.end(), {q.data[n], q.model[n], q.model[n] - q.data[n]});
    writer.add(row);
  }
  writer.flush();
}

void write_text(const std::string& path, const std::string& text)
{
  std::ofstream file(path);
  file << text;
  if (!file.flush()) throw IoError(path + ": cannot be written");
}

}  // namespace

int fit_case(const CaseFile& c, const FitOptions& options)
{
  if (!c.tables("opening").empty())
    throw CaseError("opening",
                    "makes this a 3D case; only the parameters of a case without openings can be fitted.");
  const Communicator comm;
  const lumped::FitProblem problem = problem_from_case(c, data_path(c, options));
  // On every rank, with the same result: a problem that is refused then leaves no folder behind.
  const lumped::Fit fit = lumped::fit(problem);
  common::create_output_folder(options.out_dir, options.force, c.resolved_toml(), comm);
  if (!comm.is_root()) return 0;
  const std::string text = lumped::fit_text(fit);
  write_text(options.out_dir + "/fit.txt", text);
  write_text(options.out_dir + "/fit.json", fit_json(fit));
  write_traces(options.out_dir + "/fit.csv", fit);
  Log log(true, options.out_dir + "/log.txt");
  log.line(c.section("").text("title") + "\n\n" + text);
  log.line("results in " + options.out_dir);
  return 0;
}

}  // namespace valsalva::coupling
