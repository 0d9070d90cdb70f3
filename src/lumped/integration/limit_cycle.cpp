#include "lumped/integration/limit_cycle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "common/max_or_nan.hpp"
#include "lumped/network/element_types.hpp"

namespace valsalva::lumped {

namespace {

/// The first time from which on nothing happens that does not repeat, as a multiple of the period.
double after_start_up(const NetworkSpec& spec)
{
  double latest = 0.0;
  for (const ElementSpec& e : spec.elements)
    if (const auto ramp = e.numbers.find("pressurise_s"); ramp != e.numbers.end())
      latest = std::max(latest, ramp->second);
  return spec.period_s * std::ceil(latest / spec.period_s);
}

/// A table that stops at its last value lets the network run down after one beat: there is a periodic state, but
/// not the one that was meant.
void check_sources_repeat(const NetworkSpec& spec)
{
  std::vector<CaseProblem> problems;
  for (const ElementSpec& e : spec.elements) {
    const auto beyond = e.words.find("beyond_table");
    if (e.lists.count("time_s") == 0 || (beyond != e.words.end() && beyond->second == "repeat")) continue;
    for (const auto& [key, values] : e.lists) {
      const auto [least, most] = std::minmax_element(values.begin(), values.end());
      if (key == "time_s" || values.empty() || *least == *most) continue;
      problems.push_back(
          {"", 0, 0, element_key(e, "beyond_table"),
           "is \"hold\", so the source stays at the last value of its table after one beat and has "
           "no periodic state to speak of; use beyond_table = \"repeat\"."});
    }
  }
  if (!problems.empty()) throw CaseError(problems);
}

Eigen::Map<const Eigen::VectorXd> as_vector(const std::vector<double>& v)
{
  return {v.data(), static_cast<Eigen::Index>(v.size())};
}

constexpr double kLittle_s = 1e-6;

/// The state moved on by kLittle_s along its rates.
LumpedState little_later(const LumpedNetwork& network, const LumpedState& state,
                         const std::vector<double>& no_flow)
{
  LumpedState later = state;
  std::vector<double> rates(state.y.size());
  NodalCircuit<double> circuit = network.make_circuit();
  network.rates({state.t, state.t + kTimeResolution_s}, state.y.data(), state.valve_open, no_flow, circuit,
                rates.data());
  later.t += kLittle_s;
  for (std::size_t i = 0; i < rates.size(); ++i) later.y[i] += kLittle_s * rates[i];
  return later;
}

/// One heart beat as a map of the state, with all its derivatives.
class Shooting {
 public:
  Shooting(const NetworkSpec& spec, const std::vector<std::string>& parameters, double rtol)
      : network_(spec),
        tangents_(spec, directions(network_, parameters)),
        integrator_(network_, tangents_, rtol),
        period_(spec.period_s),
        states_(network_.state_count()),
        target_(network_.initial_state())
  {
    is_closed_ = network_.keeps_volume() && network_.port_count() == 0;
    if (is_closed_) {
      target_volume_ = network_.volume(target_);
      target_gradient_ = tangents_.volume(target_, tangents_.initial()).tail(parameter_count());
    }
  }

  Eigen::Index parameter_count() const { return tangents_.count() - states_; }

  /// y(T) and the derivatives from y0 = `state`.
  void beat(const LumpedState& state)
  {
    begin_ = end_ = state;
    S_ = Eigen::MatrixXd::Identity(states_, tangents_.count());
    integrator_.advance(end_, S_, state.t + period_);
  }
  const LumpedState& end() const { return end_; }
  Eigen::MatrixXd monodromy() const { return S_.leftCols(states_); }

  double residual() const
  {
    const Eigen::ArrayXd y0 = as_vector(begin_.y), y1 = as_vector(end_.y);
    double largest = states_ > 0 ? ((y1 - y0).abs() / (1.0 + y0.abs())).maxCoeff<Eigen::PropagateNaN>() : 0.0;
    if (is_closed_) largest = max_or_nan(largest, std::abs(network_.volume(begin_) / target_volume_ - 1.0));
    return largest;
  }

  Eigen::VectorXd newton_step() const
  {
    Eigen::VectorXd right = as_vector(end_.y) - as_vector(begin_.y);
    if (is_closed_) append(right, target_volume_ - network_.volume(begin_));
    return solve(right);
  }

  /// d y0/dp of the periodic state.
  Eigen::MatrixXd gradient() const
  {
    Eigen::MatrixXd right(states_ + (is_closed_ ? 1 : 0), parameter_count());
    right.topRows(states_) = S_.rightCols(parameter_count());
    if (is_closed_) {
      // At fixed y0 the volume itself depends on the compliances.
      const Eigen::MatrixXd fixed = Eigen::MatrixXd::Identity(states_, tangents_.count());
      right.bottomRows(1) = target_gradient_ - tangents_.volume(begin_, fixed).tail(parameter_count());
    }
    return solve(right);
  }

 private:
  static std::vector<std::string> directions(const LumpedNetwork& network,
                                             const std::vector<std::string>& parameters)
  {
    std::vector<std::string> all;
    for (const auto& state : network.states()) all.push_back(state.name);
    all.insert(all.end(), parameters.begin(), parameters.end());
    return all;
  }

  static void append(Eigen::VectorXd& v, double value)
  {
    v.conservativeResize(v.size() + 1);
    v[v.size() - 1] = value;
  }

  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const
  {
    Eigen::MatrixXd matrix(right.rows(), states_);
    matrix.topRows(states_) = Eigen::MatrixXd::Identity(states_, states_) - S_.leftCols(states_);
    if (is_closed_)
      matrix.bottomRows(1) =
          tangents_.volume(begin_, Eigen::MatrixXd::Identity(states_, tangents_.count())).head(states_);
    return matrix.completeOrthogonalDecomposition().solve(right);
  }

  LumpedNetwork network_;
  Tangents tangents_;
  CvodeIntegrator integrator_;
  double period_;
  Eigen::Index states_;
  LumpedState target_;
  bool is_closed_ = false;
  double target_volume_ = 0.0;
  Eigen::RowVectorXd target_gradient_;
  LumpedState begin_, end_;
  Eigen::MatrixXd S_;
};

}  // namespace

LimitCycle find_limit_cycle(const NetworkSpec& given, const std::vector<std::string>& parameters,
                            const LimitCycleOptions& options, const LumpedState* guess)
{
  NetworkSpec spec = given;
  spec.integrals.clear();
  spec.balance = false;
  if (spec.period_s <= 0.0)
    throw CaseError("time.period_s", "is missing; a periodic state needs the length of a beat.");
  check_sources_repeat(spec);
  LumpedState state;
  if (guess) {
    state = *guess;
  } else {
    const LumpedNetwork network(spec);
    CvodeIntegrator integrator(network, options.rtol);
    state = network.initial_state();
    const std::vector<double> no_flow(static_cast<std::size_t>(network.port_count()), 0.0);
    integrator.advance(state, after_start_up(spec) + options.beats_before * spec.period_s, no_flow, no_flow);
  }
  Shooting shooting(spec, parameters, options.rtol);
  LimitCycle cycle;
  double before = std::numeric_limits<double>::infinity();
  for (int step = 0; step <= options.most_steps; ++step) {
    shooting.beat(state);
    cycle.residual = shooting.residual();
    if (cycle.residual <= options.rtol) {
      cycle.start = state;
      cycle.monodromy = shooting.monodromy();
      cycle.S = shooting.gradient();
      return cycle;
    }
    // Where a valve opens in one beat and not in the next the map has a kink: then a beat is marched.
    const bool gets_better = cycle.residual < before;
    before = cycle.residual;
    const double t = state.t;
    if (gets_better) {
      const Eigen::VectorXd step_of_y = shooting.newton_step();
      for (std::size_t i = 0; i < state.y.size(); ++i) state.y[i] += step_of_y[static_cast<Eigen::Index>(i)];
    } else {
      state = shooting.end();
      state.t = t;
    }
    ++cycle.newton_steps;
  }
  throw SolverError(fmt::format(
      "no periodic state after {} Newton steps: a beat still changes the state by {:.2g} of itself. Look for "
      "an inflow without outflow, or a source that does not repeat with the period of {} s.",
      options.most_steps, before, spec.period_s));
}

SampledBeat sample_beat(const NetworkSpec& given, const LimitCycle& cycle,
                        const std::vector<std::string>& parameters,
                        const std::vector<std::string>& observables, const std::vector<double>& times,
                        double rtol)
{
  NetworkSpec spec = given;
  spec.integrals = observables;
  spec.balance = false;
  const LumpedNetwork network(spec);
  Tangents tangents(spec, parameters);
  CvodeIntegrator integrator(network, tangents, rtol);
  const auto observed = static_cast<Eigen::Index>(observables.size());
  const auto count = static_cast<Eigen::Index>(times.size());
  std::vector<std::size_t> numbers;
  for (const std::string& name : observables)
    for (std::size_t i = 0; i < network.observables().size(); ++i)
      if (network.observables()[i].name == name) numbers.push_back(i);

  LumpedState state = cycle.start;
  state.y.resize(static_cast<std::size_t>(network.state_count()), 0.0);
  Eigen::MatrixXd S = Eigen::MatrixXd::Zero(network.state_count(), tangents.count());
  S.topRows(cycle.S.rows()) = cycle.S;
  SampledBeat beat;
  beat.values.resize(count, observed);
  beat.slopes.resize(count, observed);
  beat.gradients.assign(observables.size(), Eigen::MatrixXd(count, tangents.count()));
  const std::vector<double> no_flow(static_cast<std::size_t>(network.port_count()), 0.0);
  std::vector<double> at(times);
  for (double& t : at) t += cycle.start.t;
  Eigen::Index n = 0;
  const auto record = [&](const LumpedState& now, const Eigen::MatrixXd& S_now) {
    const std::vector<double> seen = network.observe(now, no_flow);
    const std::vector<double> later = network.observe(little_later(network, now, no_flow), no_flow);
    const Eigen::MatrixXd gradient = tangents.observe(now, S_now);
    for (Eigen::Index o = 0; o < observed; ++o) {
      const std::size_t number = numbers[static_cast<std::size_t>(o)];
      beat.values(n, o) = seen[number];
      beat.slopes(n, o) = (later[number] - seen[number]) / kLittle_s;
      beat.gradients[static_cast<std::size_t>(o)].row(n) = gradient.row(static_cast<Eigen::Index>(number));
    }
    beat.states.push_back(now);
    ++n;
  };
  const double end = cycle.start.t + std::max(spec.period_s, times.empty() ? 0.0 : times.back());
  integrator.advance(state, S, end, at, record);
  beat.integrals = as_vector(state.y).tail(observed);
  beat.integral_gradients = S.bottomRows(observed);
  return beat;
}

}  // namespace valsalva::lumped
