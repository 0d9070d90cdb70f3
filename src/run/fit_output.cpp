#include "run/fit_output.hpp"

#include "common/json.hpp"
#include "common/text_file.hpp"
#include "common/time_series.hpp"
#include "lumped/fit/fit_flags.hpp"

namespace valsalva::run {

namespace {

using common::Json;

std::string fit_json(const lumped::Fit& fit)
{
  const auto number = common::nine_digits;
  Json estimates = Json::array(), rows = Json::array(), residuals = Json::array();
  for (const lumped::Estimate& e : fit.estimates)
    estimates.push_back({{"name", e.name},
                         {"start", number(e.start)},
                         {"value", number(e.value)},
                         {"sd", number(e.sd)},
                         {"interval_95", {number(e.lowest), number(e.highest)}},
                         {"at_bound", e.at_bound}});
  for (Eigen::Index a = 0; a < fit.correlation.rows(); ++a) {
    Json row = Json::array();
    for (Eigen::Index b = 0; b < fit.correlation.cols(); ++b) row.push_back(number(fit.correlation(a, b)));
    rows.push_back(row);
  }
  for (const lumped::FitQuality& q : fit.signals)
    residuals.push_back({{"name", q.name},
                         {"samples", q.data.size()},
                         {"rms", number(q.rms)},
                         {"lag_one_correlation", number(q.lag_one)}});
  for (const lumped::FitQuality& q : fit.summaries)
    residuals.push_back(
        {{"name", q.name}, {"data", number(q.data.front())}, {"model", number(q.model.front())}});
  return common::json_text({{"estimates", estimates},
                            {"correlation", rows},
                            {"residuals", residuals},
                            {"rank", fit.rank},
                            {"condition", number(fit.condition)},
                            {"chi_squared", number(fit.chi_squared)},
                            {"residual_count", fit.residual_count},
                            {"evaluations", fit.evaluations},
                            {"converged", fit.converged},
                            {"flags", fit.flags}});
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
