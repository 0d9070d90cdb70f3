#include "run/fit_output.hpp"

#include <fmt/format.h>

#include <cmath>

#include "common/json_text.hpp"
#include "common/text_file.hpp"
#include "common/time_series.hpp"
#include "lumped/fit/fit_flags.hpp"

namespace valsalva::run {

namespace {

/// JSON has no infinity.
std::string json_number(double value)
{
  return std::isfinite(value) ? fmt::format("{:.9g}", value) : "null";
}

std::string fit_json(const lumped::Fit& fit)
{
  std::vector<std::string> estimates, rows, qualities, flags;
  for (const lumped::Estimate& e : fit.estimates)
    estimates.push_back(
        fmt::format("    {{\"name\": {}, \"start\": {}, \"value\": {}, \"sd\": {}, \"interval_95\": [{}, "
                    "{}], \"at_bound\": {}}}",
                    common::json_quoted(e.name), json_number(e.start), json_number(e.value),
                    json_number(e.sd), json_number(e.lowest), json_number(e.highest), e.at_bound));
  for (Eigen::Index a = 0; a < fit.correlation.rows(); ++a) {
    std::vector<std::string> row;
    for (Eigen::Index b = 0; b < fit.correlation.cols(); ++b)
      row.push_back(json_number(fit.correlation(a, b)));
    rows.push_back(fmt::format("    [{}]", fmt::join(row, ", ")));
  }
  for (const lumped::FitQuality& q : fit.signals)
    qualities.push_back(
        fmt::format("    {{\"name\": {}, \"samples\": {}, \"rms\": {}, \"lag_one_correlation\": {}}}",
                    common::json_quoted(q.name), q.data.size(), json_number(q.rms), json_number(q.lag_one)));
  for (const lumped::FitQuality& q : fit.summaries)
    qualities.push_back(fmt::format("    {{\"name\": {}, \"data\": {}, \"model\": {}}}",
                                    common::json_quoted(q.name), json_number(q.data.front()),
                                    json_number(q.model.front())));
  for (const std::string& flag : fit.flags) flags.push_back("    " + common::json_quoted(flag));
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

}  // namespace

std::string write_fit(const std::string& folder, const lumped::Fit& fit)
{
  const std::string text = lumped::fit_text(fit);
  common::write_text_file(folder + "/fit.txt", text);
  common::write_text_file(folder + "/fit.json", fit_json(fit));
  write_traces(folder + "/fit.csv", fit);
  return text;
}

}  // namespace valsalva::run
