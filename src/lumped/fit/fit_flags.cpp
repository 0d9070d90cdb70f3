#include "lumped/fit/fit_flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/max_or_nan.hpp"
#include "lumped/network/element_types.hpp"

namespace valsalva::lumped {

namespace {

constexpr double kUnidentified = 1.0, kPoor = 0.3;  // relative standard deviations
constexpr double kCollinear = 0.98;
constexpr double kCorrelatedResiduals = 0.5;
constexpr double kRoundingOfRange = 1e-6;  // residuals below are those of the integration
constexpr double kRounding = 1e-6;         // of a sample interval
constexpr double kTakesPart = 0.02;        // of the largest entry of a free direction

double range(const std::vector<double>& values)
{
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low;
}

/// Empty if the times cover one period, with or without the sample that closes it.
std::string length_flag(const std::string& what, const std::vector<double>& t, double period)
{
  if (t.size() < 3) return "";
  double interval = 0.0;
  for (std::size_t n = 1; n < t.size(); ++n) interval = max_or_nan(interval, t[n] - t[n - 1]);
  const double length = t.back() - t.front() + interval;
  if (std::abs(length - period) <= (1.0 + kRounding) * interval) return "";
  return fmt::format(
      "{} cover{} {:.4g} s (samples up to {:.4g} s apart), but the beat lasts time.period_s = {:.4g} s. "
      "Set the period to the length of the measured beat, or cut the data to one beat.",
      what, what.starts_with("The data") ? "" : "s", length, interval, period);
}

/// "only the combination of a and b is determined: ..."
std::string free_direction(const Eigen::VectorXd& direction, const std::vector<Unknown>& unknowns)
{
  std::vector<std::string> names, moves;
  for (std::size_t k = 0; k < unknowns.size(); ++k) {
    const double d = direction[static_cast<Eigen::Index>(k)];
    if (std::abs(d) < kTakesPart) continue;
    names.push_back(unknowns[k].name);
    moves.push_back(unknowns[k].is_log
                        ? fmt::format("{} {:+.2g} %", unknowns[k].name, 100.0 * std::expm1(0.1 * d))
                        : fmt::format("{} {:+.2g}", unknowns[k].name, 0.1 * d));
  }
  if (names.size() == 1)
    return fmt::format("{} has no influence on the data; fix it or measure something that depends on it.",
                       names.front());
  return fmt::format(
      "{} cannot be told apart: the data determine only a combination of them. This change is invisible: {}. "
      "Fix all but one of them.",
      fmt::join(names, " and "), fmt::join(moves, ", "));
}

}  // namespace

std::vector<std::string> fit_flags(const Fit& fit, const std::vector<Unknown>& unknowns)
{
  std::vector<std::string> flags;
  if (!fit.converged)
    flags.push_back(
        fmt::format("The search stopped after {} evaluations without converging; start nearer, or "
                    "fix a parameter.",
                    fit.evaluations));
  for (Eigen::Index c = 0; c < fit.free_directions.cols(); ++c)
    flags.push_back(free_direction(fit.free_directions.col(c), unknowns));
  for (const Estimate& e : fit.estimates) {
    if (e.at_bound)
      flags.push_back(
          fmt::format("{} lies at its bound {:.4g}; its interval says nothing.", e.name, e.value));
    if (std::isinf(e.sd) || e.name.starts_with("baseline") || e.name.starts_with("shift")) continue;
    if (e.relative_sd > kUnidentified)
      flags.push_back(
          fmt::format("{} is not identified by these data: its standard deviation is {:.0f} % of its "
                      "value. Fix it.",
                      e.name, 100.0 * e.relative_sd));
    else if (e.relative_sd > kPoor)
      flags.push_back(fmt::format("{} is poorly identified: its standard deviation is {:.0f} % of its value.",
                                  e.name, 100.0 * e.relative_sd));
  }
  for (std::size_t a = 0; a < fit.estimates.size(); ++a)
    for (std::size_t b = a + 1; b < fit.estimates.size(); ++b) {
      const double rho = fit.correlation(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
      if (std::abs(rho) > kCollinear && std::isfinite(fit.estimates[a].sd) &&
          std::isfinite(fit.estimates[b].sd))
        flags.push_back(
            fmt::format("{} and {} are nearly interchangeable: the correlation of their estimates is "
                        "{:.3f}.",
                        fit.estimates[a].name, fit.estimates[b].name, rho));
    }
  for (const FitQuality& q : fit.signals)
    if (q.lag_one > kCorrelatedResiduals && q.rms > kRoundingOfRange * range(q.data))
      flags.push_back(
          fmt::format("The residuals of {} are correlated in time (neighbours: {:.2f}), so the model misses "
                      "a shape in the "
                      "data; the true standard deviations are about {:.1f} times the reported ones.",
                      q.name, q.lag_one, std::sqrt((1.0 + q.lag_one) / (1.0 - q.lag_one))));
  return flags;
}

std::vector<std::string> data_flags(const FitProblem& problem)
{
  std::vector<std::string> flags;
  if (!problem.periodic) return flags;
  const auto add = [&](const std::string& what, const std::vector<double>& t) {
    if (std::string flag = length_flag(what, t, problem.network.period_s); !flag.empty())
      flags.push_back(flag);
  };
  for (const FitSignal& s : problem.signals) add("The data of " + s.name, s.t);
  for (const ElementSpec& e : problem.network.elements)
    if (e.words.count("column") > 0 && e.lists.count("time_s") > 0)
      add("The table of " + element_key(e), e.lists.at("time_s"));
  return flags;
}

std::string fit_text(const Fit& fit)
{
  std::string text =
      fmt::format("{:<34}{:>12}{:>12}{:>12}   {}\n", "parameter", "start", "estimate", "sd", "95 % interval");
  for (const Estimate& e : fit.estimates)
    text += fmt::format("{:<34}{:>12.6g}{:>12.6g}{:>12.3g}   {:.6g} to {:.6g}\n", e.name, e.start, e.value,
                        e.sd, e.lowest, e.highest);
  if (fit.estimates.size() > 1) {
    text += "\ncorrelations, in the same order\n";
    for (Eigen::Index a = 0; a < fit.correlation.rows(); ++a) {
      for (Eigen::Index b = 0; b < fit.correlation.cols(); ++b)
        text += fmt::format("{:>8.3f}", fit.correlation(a, b));
      text += '\n';
    }
  }
  text += "\nresiduals\n";
  for (const FitQuality& q : fit.signals)
    text += fmt::format("{:<34}rms {:.4g} over {} samples\n", q.name, q.rms, q.data.size());
  for (const FitQuality& q : fit.summaries)
    text += fmt::format("{:<34}data {:.5g}, model {:.5g}\n", q.name, q.data.front(), q.model.front());
  text += fmt::format("\ninformation matrix: rank {} of {}, condition {:.2g}; {} residuals, {} evaluations\n",
                      fit.rank, fit.estimates.size(), fit.condition, fit.residual_count, fit.evaluations);
  text += fmt::format("standard deviations from {}\n",
                      fit.sd_is_known ? "the stated ones of the measurements" : "the residuals");
  for (const std::string& flag : fit.flags) text += "\n! " + flag;
  return text + (fit.flags.empty() ? "" : "\n");
}

}  // namespace valsalva::lumped
