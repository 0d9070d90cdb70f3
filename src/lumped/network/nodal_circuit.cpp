#include "lumped/network/nodal_circuit.hpp"

#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "common/max_or_nan.hpp"

namespace valsalva::lumped {

namespace {

/// Gaussian elimination in place, `matrix` row by row; the solution replaces `x`. No pivoting is needed.
template <class Scalar>
void solve_positive_definite(std::vector<Scalar>& matrix, std::vector<Scalar>& x)
{
  const std::size_t n = x.size();
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = k + 1; i < n; ++i) {
      const Scalar factor = matrix[i * n + k] / matrix[k * n + k];
      for (std::size_t j = k + 1; j < n; ++j) matrix[i * n + j] -= factor * matrix[k * n + j];
      x[i] -= factor * x[k];
    }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) x[k] -= matrix[k * n + j] * x[j];
    x[k] /= matrix[k * n + k];
  }
}

}  // namespace

template <class Scalar>
NodalCircuit<Scalar>::NodalCircuit(int nodes) : nodes_(static_cast<std::size_t>(nodes))
{
}

template <class Scalar>
void NodalCircuit<Scalar>::clear()
{
  for (Node& n : nodes_) n = Node{};
  resistors_.clear();
}

template <class Scalar>
void NodalCircuit<Scalar>::hold_pressure(int node, const Scalar& p)
{
  at(node).held = true;
  at(node).held_pressure = p;
}

template <class Scalar>
void NodalCircuit<Scalar>::add_pressure(int node, const Scalar& p, const Scalar& R)
{
  at(node).inflow += p / R;
  at(node).conductance += 1.0 / R;
}

template <class Scalar>
void NodalCircuit<Scalar>::add_inflow(int node, const Scalar& Q)
{
  at(node).inflow += Q;
}

template <class Scalar>
void NodalCircuit<Scalar>::add_resistor(int from, int to, const Scalar& R, const Scalar& B)
{
  resistors_.push_back({from, to, R, B, 0.0});
  ++at(from).resistors;
  ++at(to).resistors;
}

template <class Scalar>
void NodalCircuit<Scalar>::solve()
{
  for (Node& n : nodes_) {
    n.impedance = n.held ? 0.0 : 1.0 / n.conductance;
    n.pressure = n.held ? n.held_pressure : n.inflow * n.impedance;
  }
  if (resistors_are_coupled()) {
    solve_coupled_resistors();
  } else {
    for (Resistor& r : resistors_) {
      const Node &a = at(r.from), &b = at(r.to);
      r.Q = resistor_flow<Scalar>(a.pressure - b.pressure, r.R + a.impedance + b.impedance, r.B);
    }
  }
  for (const Resistor& r : resistors_) {
    at(r.from).resistor_inflow -= r.Q;
    at(r.to).resistor_inflow += r.Q;
  }
  for (Node& n : nodes_) {
    n.pressure += n.impedance * n.resistor_inflow;
    n.excess = n.held ? n.inflow + n.resistor_inflow - n.conductance * n.pressure : 0.0;
  }
}

template <class Scalar>
bool NodalCircuit<Scalar>::resistors_are_coupled() const
{
  if (resistors_.size() < 2) return false;
  for (const Node& n : nodes_)
    if (!n.held && n.resistors > 1) return true;
  return false;
}

template <class Scalar>
void NodalCircuit<Scalar>::solve_coupled_resistors()
{
  using std::abs;
  const std::size_t count = resistors_.size();
  impedance_.resize(count * count);
  drive_.resize(count);
  Q_.assign(count, 0.0);
  residual_.resize(count);
  const auto incidence = [](const Resistor& r, int node) {
    return 1.0 * ((r.from == node) - (r.to == node));
  };
  for (std::size_t i = 0; i < count; ++i) {
    const Resistor& ri = resistors_[i];
    const Node &a = at(ri.from), &b = at(ri.to);
    drive_[i] = a.pressure - b.pressure;
    for (std::size_t j = 0; j < count; ++j)
      impedance_[i * count + j] =
          a.impedance * incidence(resistors_[j], ri.from) - b.impedance * incidence(resistors_[j], ri.to);
  }
  for (int iteration = 0; iteration < 100; ++iteration) {
    jacobian_ = impedance_;
    for (std::size_t i = 0; i < count; ++i) {
      const Resistor& r = resistors_[i];
      const Scalar speed = abs(Q_[i]);
      residual_[i] = (r.R + r.B * speed) * Q_[i] - drive_[i];
      for (std::size_t j = 0; j < count; ++j) residual_[i] += impedance_[i * count + j] * Q_[j];
      jacobian_[i * count + i] += r.R + 2.0 * r.B * speed;
    }
    solve_positive_definite(jacobian_, residual_);
    double largest_change = 0.0, largest_flow = 1e-6;
    for (std::size_t i = 0; i < count; ++i) {
      Q_[i] -= residual_[i];
      largest_change = max_or_nan(largest_change, std::abs(value_of(residual_[i])));
      largest_flow = max_or_nan(largest_flow, std::abs(value_of(Q_[i])));
    }
    if (largest_change <= 1e-13 * largest_flow) {
      for (std::size_t i = 0; i < count; ++i) resistors_[i].Q = Q_[i];
      return;
    }
  }
  throw SolverError(
      "the flows through the open valves of the lumped network could not be found; a pressure or flow is not "
      "a "
      "finite number");
}

template class NodalCircuit<double>;
template class NodalCircuit<Dual>;

}  // namespace valsalva::lumped
