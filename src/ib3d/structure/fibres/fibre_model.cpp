#include "ib3d/structure/fibres/fibre_model.hpp"

#include <algorithm>
#include <array>

#include "ib3d/structure/fibres/fibre_force.hpp"
#include "ib3d/structure/fibres/fibre_strain.hpp"
#include "ib3d/structure/fibres/fold_relaxation.hpp"

namespace valsalva::ib3d {

void FibreModel::add_force(std::span<const Vec3> X, std::span<Vec3> F) const
{
  add_fibre_force(network_, X, F);
}

double FibreModel::energy(std::span<const Vec3> X) const
{
  return fibre_energy(network_, X);
}

void FibreModel::add_stiffness_times(std::span<const Vec3> X, std::span<const Vec3> v,
                                     std::span<Vec3> Kv) const
{
  add_fibre_stiffness_times(network_, X, v, Kv, SlackSprings::just_taut);
}

void FibreModel::add_slip(std::span<const Vec3> X, double dt, std::span<Vec3> U) const
{
  // Steps longer than the time would overshoot.
  if (fold_relaxation_ > 0) add_fold_slip(network_, X, std::max(fold_relaxation_, dt), U);
}

Elements FibreModel::elements() const
{
  Elements all;
  for (std::size_t n = 0; n < network_.springs.a.size(); ++n)
    all.add(std::array{network_.springs.a[n], network_.springs.b[n]});
  for (std::size_t n = 0; n < network_.beams.x0.size(); ++n)
    all.add(std::array{network_.beams.x0[n], network_.beams.x1[n], network_.beams.x2[n]});
  for (const int& node : network_.tethers.node) all.add({&node, 1});
  return all;
}

std::unique_ptr<const ElasticModel> FibreModel::part(const Selection& selection) const
{
  FibreNetwork part;
  for (const int node : selection.nodes) part.X.push_back(network_.X[static_cast<std::size_t>(node)]);
  const auto number = [&](int node) { return selection.number[static_cast<std::size_t>(node)]; };
  const Springs& s = network_.springs;
  const Beams& b = network_.beams;
  const Tethers& t = network_.tethers;
  for (const int e : selection.elements) {
    auto n = static_cast<std::size_t>(e);
    if (n < s.a.size()) {
      part.springs.add(number(s.a[n]), number(s.b[n]), s.stiffness[n], s.rest_length[n],
                       s.tension_only[n] != 0);
      continue;
    }
    n -= s.a.size();
    if (n < b.x0.size()) {
      part.beams.add({number(b.x0[n]), number(b.x1[n]), number(b.x2[n])}, b.rigidity[n], b.l1[n], b.l2[n]);
      continue;
    }
    n -= b.x0.size();
    part.tethers.add(number(t.node[n]), t.stiffness[n], t.target[n]);
  }
  return std::make_unique<FibreModel>(std::move(part), fold_relaxation_);
}

Deformation FibreModel::deformation(std::span<const Vec3> X) const
{
  const NodeGroup everything{"all", 0, node_count()};
  return {fibre_strain(network_, X, everything).largest, largest_tether_displacement(network_, X)};
}

StrainedElements FibreModel::drawing(std::span<const Vec3> X) const
{
  StrainedElements lines;
  const Springs& s = network_.springs;
  for (std::size_t n = 0; n < s.a.size(); ++n) {
    lines.elements.add(std::array{s.a[n], s.b[n]});
    const Vec3 apart = X[static_cast<std::size_t>(s.b[n])] - X[static_cast<std::size_t>(s.a[n])];
    lines.strain.push_back(norm(apart) / s.rest_length[n] - 1);
  }
  return lines;
}

}  // namespace valsalva::ib3d
