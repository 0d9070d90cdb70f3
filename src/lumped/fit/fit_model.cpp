#include "lumped/fit/fit_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "common/error.hpp"
#include "common/nearest_name.hpp"
#include "lumped/network/element_types.hpp"

namespace valsalva::lumped {

namespace {

constexpr int kSummarySamples = 800;    // per beat, for the largest and smallest value
constexpr double kLargestShift = 0.25;  // of the period

/// A value with its gradient.
struct Traced {
  double value;
  Eigen::RowVectorXd gradient;
};

/// The extreme of a sampled signal: the vertex of the parabola through the extreme sample and its neighbours.
Traced extreme(const Eigen::VectorXd& y, const Eigen::MatrixXd& dy, bool is_maximum)
{
  Eigen::Index n = 0;
  is_maximum ? y.maxCoeff(&n) : y.minCoeff(&n);
  const Eigen::Index last = y.size() - 1, a = n == 0 ? last : n - 1, b = n == last ? 0 : n + 1;
  const double slope = y[b] - y[a], curvature = y[a] - 2.0 * y[n] + y[b];
  if (curvature == 0.0) return {y[n], dy.row(n)};
  const double s = slope / (4.0 * curvature);
  return {y[n] - 0.5 * s * slope,
          dy.row(n) - s * (dy.row(b) - dy.row(a)) + 2.0 * s * s * (dy.row(a) - 2.0 * dy.row(n) + dy.row(b))};
}

/// Mean, integral, or extreme of observable `o`; `rows` are the samples that cover the beat evenly.
Traced summary_of(SummaryKind kind, const SampledBeat& beat, Eigen::Index o, double period,
                  std::span<const Eigen::Index> rows)
{
  if (kind == SummaryKind::volume) return {beat.integrals[o], beat.integral_gradients.row(o)};
  if (kind == SummaryKind::mean) return {beat.integrals[o] / period, beat.integral_gradients.row(o) / period};
  const Eigen::MatrixXd& gradient = beat.gradients[static_cast<std::size_t>(o)];
  Eigen::VectorXd y(kSummarySamples);
  Eigen::MatrixXd dy(kSummarySamples, gradient.cols());
  for (Eigen::Index n = 0; n < kSummarySamples; ++n) {
    y[n] = beat.values(rows[static_cast<std::size_t>(n)], o);
    dy.row(n) = gradient.row(rows[static_cast<std::size_t>(n)]);
  }
  return extreme(y, dy, kind == SummaryKind::systolic);
}

/// Times in order, and where each of the given ones has gone.
struct Sorted {
  std::vector<double> times;
  std::vector<Eigen::Index> row;
};

Sorted sort_times(const std::vector<double>& times)
{
  std::vector<std::size_t> order(times.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return times[a] < times[b]; });
  Sorted sorted{{}, std::vector<Eigen::Index>(times.size())};
  for (std::size_t n : order) {
    sorted.row[n] = static_cast<Eigen::Index>(sorted.times.size());
    sorted.times.push_back(times[n]);
  }
  return sorted;
}

bool allows_no_negative(const NetworkSpec& spec, const std::string& name)
{
  for (const ElementSpec& e : spec.elements)
    for (const ElementParameter& p : find_element_type(e.type)->parameters)
      if (name == e.name + "." + p.name) return p.lowest >= 0.0;
  return false;
}

}  // namespace

double Unknown::to_x(double value) const
{
  return is_log ? std::log(value) : value;
}

double Unknown::from_x(double x) const
{
  return is_log ? std::exp(x) : x;
}

FitModel::FitModel(const FitProblem& problem) : problem_(problem)
{
  if (problem.periodic && problem.network.period_s <= 0.0)
    throw CaseError("time.period_s", "is missing; a fit to a periodic beat needs its length.");
  add_parameters();
  const auto add_observable = [&](const std::string& name) {
    if (std::find(observables_.begin(), observables_.end(), name) == observables_.end())
      observables_.push_back(name);
  };
  for (const FitSignal& s : problem.signals) {
    add_observable(s.observable);
    places_.emplace_back();
    const double inf = std::numeric_limits<double>::infinity(), T = problem.network.period_s;
    if (s.has_baseline) {
      places_.back().baseline = static_cast<Eigen::Index>(unknowns_.size());
      unknowns_.push_back({"baseline of " + s.name, false, 0.0, -inf, inf});
    }
    if (s.has_shift) {
      places_.back().shift = static_cast<Eigen::Index>(unknowns_.size());
      unknowns_.push_back({"shift of " + s.name + " (s)", false, 0.0, -kLargestShift * T, kLargestShift * T});
    }
  }
  for (const FitSummary& s : problem.summaries) add_observable(s.observable);
  check_observables();
  if (unknowns_.empty()) throw CaseError("fit_parameter", "is missing; name at least one free parameter.");
  if (problem.signals.empty() && problem.summaries.empty())
    throw CaseError("fit_signal", "is missing; give a signal or a target to fit to.");
  if (!sd_is_known() && problem.signals.size() + problem.summaries.size() > 1)
    throw CaseError("fit_signal",
                    "has no sd; where several signals or targets are fitted together each "
                    "needs the standard deviation of its measurement.");
}

void FitModel::add_parameters()
{
  for (const FitParameter& p : problem_.parameters) {
    const double start = parameter_of(problem_.network, p.name);
    const std::string key = "fit_parameter \"" + p.name + "\"";
    const bool is_log = allows_no_negative(problem_.network, p.name);
    if (is_log && start <= 0.0)
      throw CaseError(key, fmt::format("starts at {}; it is searched on a logarithmic scale and needs a "
                                       "start above 0. Give the element a positive value.",
                                       start));
    if (!(p.lowest <= start && start <= p.highest))
      throw CaseError(key,
                      fmt::format("starts at {}, outside its bounds {} to {}.", start, p.lowest, p.highest));
    unknowns_.push_back({p.name, is_log, start, is_log ? std::max(p.lowest, 0.0) : p.lowest, p.highest});
    parameters_.push_back(p.name);
  }
}

void FitModel::check_observables() const
{
  const LumpedNetwork network(problem_.network);
  std::vector<std::string> known;
  for (const Quantity& q : network.observables()) known.push_back(q.name);
  for (const std::string& name : observables_)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw CaseError("observable \"" + name + "\"",
                      fmt::format("is not in the network{}. Known are {}.", common::did_you_mean(name, known),
                                  fmt::join(known, ", ")));
}

double FitModel::sd(std::size_t signal) const
{
  const double given = problem_.signals[signal].sd;
  return given > 0.0 ? given : 1.0;
}

bool FitModel::sd_is_known() const
{
  return std::all_of(problem_.signals.begin(), problem_.signals.end(),
                     [](const FitSignal& s) { return s.sd > 0.0; });
}

LimitCycle FitModel::beginning(const NetworkSpec& spec)
{
  if (problem_.periodic) {
    LimitCycleOptions options;
    options.rtol = problem_.rtol;
    LimitCycle cycle = find_limit_cycle(spec, parameters_, options, guess_ ? &*guess_ : nullptr);
    guess_ = cycle.start;
    return cycle;
  }
  LimitCycle start;
  start.start = LumpedNetwork(spec).initial_state();
  start.S = Tangents(spec, parameters_).initial();
  return start;
}

double FitModel::model_time(double t) const
{
  const double T = problem_.network.period_s;
  return problem_.periodic ? t - T * std::floor(t / T) : std::max(t, 0.0);
}

void FitModel::evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd& J)
{
  NetworkSpec spec = problem_.network;
  const auto n_parameters = static_cast<Eigen::Index>(parameters_.size());
  Eigen::RowVectorXd dp_dx(n_parameters);
  for (Eigen::Index k = 0; k < n_parameters; ++k) {
    const Unknown& u = unknowns_[static_cast<std::size_t>(k)];
    double& value = parameter_of(spec, u.name);
    value = u.from_x(x[k]);
    dp_dx[k] = u.is_log ? value : 1.0;
  }

  // All times at which anything is asked.
  std::vector<double> times;
  for (std::size_t s = 0; s < problem_.signals.size(); ++s)
    for (double t : problem_.signals[s].t)
      times.push_back(model_time(t + (places_[s].shift < 0 ? 0.0 : x[places_[s].shift])));
  if (!problem_.summaries.empty())
    for (int n = 0; n < kSummarySamples; ++n) times.push_back(spec.period_s * n / kSummarySamples);
  const Sorted samples = sort_times(times);
  const SampledBeat beat =
      sample_beat(spec, beginning(spec), parameters_, observables_, samples.times, problem_.rtol);
  const auto observable = [&](const std::string& name) {
    return std::find(observables_.begin(), observables_.end(), name) - observables_.begin();
  };

  const std::size_t summary_times = problem_.summaries.empty() ? 0 : kSummarySamples;
  const std::size_t signal_times = times.size() - summary_times;
  r.resize(static_cast<Eigen::Index>(signal_times + problem_.summaries.size()));
  J = Eigen::MatrixXd::Zero(r.size(), x.size());
  Eigen::Index i = 0;
  for (std::size_t s = 0; s < problem_.signals.size(); ++s) {
    const FitSignal& signal = problem_.signals[s];
    const auto o = observable(signal.observable);
    for (std::size_t n = 0; n < signal.t.size(); ++n, ++i) {
      const Eigen::Index at = samples.row[static_cast<std::size_t>(i)];
      const double baseline = places_[s].baseline < 0 ? 0.0 : x[places_[s].baseline];
      r[i] = (beat.values(at, o) + baseline - signal.value[n]) / sd(s);
      J.row(i).head(n_parameters) =
          beat.gradients[static_cast<std::size_t>(o)].row(at).cwiseProduct(dp_dx) / sd(s);
      if (places_[s].baseline >= 0) J(i, places_[s].baseline) = 1.0 / sd(s);
      if (places_[s].shift >= 0) J(i, places_[s].shift) = beat.slopes(at, o) / sd(s);
    }
  }
  for (const FitSummary& summary : problem_.summaries) {
    const auto o = observable(summary.observable);
    const Traced traced =
        summary_of(summary.kind, beat, o, spec.period_s, std::span(samples.row).subspan(signal_times));
    r[i] = (traced.value - summary.value) / summary.sd;
    J.row(i++).head(n_parameters) = traced.gradient.cwiseProduct(dp_dx) / summary.sd;
  }
}

}  // namespace valsalva::lumped
