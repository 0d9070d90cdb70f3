#include "lumped/integration/tangents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "common/nearest_name.hpp"
#include "lumped/network/complete_spec.hpp"

namespace valsalva::lumped {

namespace {

/// The parameter in a completed spec, or nullptr.
double* find_parameter(NetworkSpec& spec, const std::string& name)
{
  for (ElementSpec& e : spec.elements) {
    if (!name.starts_with(e.name + ".")) continue;
    const std::string key = name.substr(e.name.size() + 1);
    if (const auto number = e.numbers.find(key); number != e.numbers.end()) return &number->second;
    if (const auto list = e.lists.find(key); list != e.lists.end() && list->second.size() == 1)
      return &list->second.front();
  }
  return nullptr;
}

std::vector<std::string> parameter_names(const NetworkSpec& spec)
{
  std::vector<std::string> names;
  for (const ElementSpec& e : spec.elements) {
    for (const auto& number : e.numbers) names.push_back(e.name + "." + number.first);
    for (const auto& list : e.lists)
      if (list.second.size() == 1) names.push_back(e.name + "." + list.first);
  }
  return names;
}

[[noreturn]] void refuse(const std::string& name, const std::vector<std::string>& known)
{
  throw CaseError("parameter \"" + name + "\"",
                  fmt::format("is not a number of the network{}. Known are {}.",
                              common::did_you_mean(name, known), fmt::join(known, ", ")));
}

}  // namespace

double& parameter_of(NetworkSpec& spec, const std::string& name)
{
  spec = complete_spec(std::move(spec));
  if (double* found = find_parameter(spec, name)) return *found;
  refuse(name, parameter_names(spec));
}

Tangents::Tangents(const NetworkSpec& spec, std::vector<std::string> directions)
    : directions_(std::move(directions))
{
  NetworkSpec complete = complete_spec(spec);
  const LumpedNetwork plain(complete);
  for (const std::string& name : directions_) {
    const double* parameter = find_parameter(complete, name);
    const bool is_state = std::any_of(plain.states().begin(), plain.states().end(),
                                      [&](const auto& state) { return state.name == name; });
    if (!parameter && !is_state) {
      std::vector<std::string> known = parameter_names(complete);
      for (const auto& state : plain.states()) known.push_back(state.name);
      refuse(name, known);
    }
    scales_.push_back(parameter && *parameter != 0.0 ? std::abs(*parameter) : 1.0);
  }
  for (std::size_t first = 0; first < directions_.size(); first += kLanes) {
    const std::size_t lanes = std::min<std::size_t>(kLanes, directions_.size() - first);
    auto network =
        std::make_unique<Network<Dual>>(complete, std::span<const std::string>(&directions_[first], lanes));
    NodalCircuit<Dual> circuit = network->make_circuit();
    bundles_.push_back({std::move(network), std::move(circuit), static_cast<Eigen::Index>(first),
                        static_cast<Eigen::Index>(lanes)});
  }
  observable_count_ = static_cast<Eigen::Index>(plain.observables().size());
  no_flow_.assign(static_cast<std::size_t>(plain.port_count()), 0.0);
  y_.resize(static_cast<std::size_t>(plain.state_count()));
  rates_ = y_;
}

Eigen::MatrixXd Tangents::initial() const
{
  Eigen::MatrixXd S = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(y_.size()), count());
  for (const Bundle& b : bundles_) {
    const NetworkState<Dual> start = b.network->initial_state();
    for (Eigen::Index i = 0; i < S.rows(); ++i)
      for (Eigen::Index k = 0; k < b.count; ++k) {
        const auto row = static_cast<std::size_t>(i);
        const bool is_this =
            b.network->states()[row].name == directions_[static_cast<std::size_t>(b.first + k)];
        S(i, b.first + k) = is_this ? 1.0 : start.y[row].tangent[k];
      }
  }
  return S;
}

void Tangents::rates(Instant now, const double* y, std::span<const int> valve_open, const double* const* S,
                     double* const* dSdt)
{
  for (Bundle& b : bundles_) {
    for (std::size_t i = 0; i < y_.size(); ++i) {
      y_[i].value = y[i];
      for (Eigen::Index k = 0; k < b.count; ++k) y_[i].tangent[k] = S[b.first + k][i];
    }
    b.network->rates(now, y_.data(), valve_open, no_flow_, b.circuit, rates_.data());
    for (std::size_t i = 0; i < y_.size(); ++i)
      for (Eigen::Index k = 0; k < b.count; ++k) dSdt[b.first + k][i] = rates_[i].tangent[k];
  }
}

NetworkState<Dual> Tangents::dual_state(const Bundle& b, const LumpedState& state,
                                        const Eigen::MatrixXd& S) const
{
  NetworkState<Dual> dual{state.t, {}, state.valve_open};
  for (std::size_t i = 0; i < state.y.size(); ++i) {
    dual.y.emplace_back(state.y[i]);
    for (Eigen::Index k = 0; k < b.count; ++k)
      dual.y[i].tangent[k] = S(static_cast<Eigen::Index>(i), b.first + k);
  }
  return dual;
}

void Tangents::follow_switch(int valve, const LumpedState& state, Eigen::MatrixXd& S) const
{
  for (const Bundle& b : bundles_) {
    NetworkState<Dual> dual = dual_state(b, state, S);
    dual.valve_open[static_cast<std::size_t>(valve)] ^= 1;  // back to its position before
    b.network->switch_valve(valve, dual);
    for (std::size_t i = 0; i < dual.y.size(); ++i)
      for (Eigen::Index k = 0; k < b.count; ++k)
        S(static_cast<Eigen::Index>(i), b.first + k) = dual.y[i].tangent[k];
  }
}

void Tangents::follow_kink(double t_before, double t_after, const LumpedState& state, Eigen::MatrixXd& S)
{
  for (Bundle& b : bundles_) {
    const Dual::Tangent moved = b.network->next_kink(t_before).tangent;
    if ((moved == 0.0).all()) continue;
    const NetworkState<Dual> dual = dual_state(b, state, S);
    std::vector<Dual> before(dual.y.size()), after(dual.y.size());
    b.network->rates({state.t, 0.5 * (t_before + state.t)}, dual.y.data(), state.valve_open, no_flow_,
                     b.circuit, before.data());
    b.network->rates({state.t, t_after}, dual.y.data(), state.valve_open, no_flow_, b.circuit, after.data());
    for (std::size_t i = 0; i < dual.y.size(); ++i)
      for (Eigen::Index k = 0; k < b.count; ++k)
        S(static_cast<Eigen::Index>(i), b.first + k) += (before[i].value - after[i].value) * moved[k];
  }
}

Eigen::MatrixXd Tangents::observe(const LumpedState& state, const Eigen::MatrixXd& S) const
{
  Eigen::MatrixXd result(observable_count_, count());
  for (const Bundle& b : bundles_) {
    const std::vector<Dual> seen = b.network->observe(dual_state(b, state, S), no_flow_);
    for (std::size_t i = 0; i < seen.size(); ++i)
      for (Eigen::Index k = 0; k < b.count; ++k)
        result(static_cast<Eigen::Index>(i), b.first + k) = seen[i].tangent[k];
  }
  return result;
}

Eigen::RowVectorXd Tangents::volume(const LumpedState& state, const Eigen::MatrixXd& S) const
{
  Eigen::RowVectorXd result(count());
  for (const Bundle& b : bundles_) {
    const Dual volume = b.network->volume(dual_state(b, state, S));
    for (Eigen::Index k = 0; k < b.count; ++k) result[b.first + k] = volume.tangent[k];
  }
  return result;
}

}  // namespace valsalva::lumped
