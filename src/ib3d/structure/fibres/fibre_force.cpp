#include "ib3d/structure/fibres/fibre_force.hpp"

#include <cmath>

#include "ib3d/structure/fibres/beam.hpp"

namespace valsalva::ib3d {

namespace {

std::size_t at(int node)
{
  return static_cast<std::size_t>(node);
}

bool is_slack(const Springs& springs, std::size_t n, double stretch)
{
  return springs.tension_only[n] != 0 && stretch < 0.0;
}

/// Adds sign * (the beams' force at X); the force is linear in X, so the same loop serves the tangent.
void add_beam_force(const Beams& beams, std::span<const Vec3> X, double sign, std::span<Vec3> F)
{
  const std::size_t count = beams.x0.size();
  for (std::size_t n = 0; n < count; ++n) {
    const Beam beam(beams, n);
    beam.add_force((sign * beam.stiffness) * beam.turn(X), F);
  }
}

}  // namespace

void add_fibre_force(const FibreNetwork& network, std::span<const Vec3> X, std::span<Vec3> F)
{
  const Springs& springs = network.springs;
  for (std::size_t n = 0; n < springs.a.size(); ++n) {
    const std::size_t a = at(springs.a[n]), b = at(springs.b[n]);
    const Vec3 r = X[b] - X[a];
    const double l = norm(r);
    const double stretch = l / springs.rest_length[n] - 1.0;
    if (l == 0.0 || is_slack(springs, n, stretch)) continue;
    const Vec3 pull = (springs.stiffness[n] * stretch / l) * r;
    F[a] += pull;
    F[b] -= pull;
  }
  add_beam_force(network.beams, X, 1.0, F);
  const Tethers& tethers = network.tethers;
  for (std::size_t n = 0; n < tethers.node.size(); ++n) {
    const std::size_t i = at(tethers.node[n]);
    F[i] += tethers.stiffness[n] * (tethers.target[n] - X[i]);
  }
}

double fibre_energy(const FibreNetwork& network, std::span<const Vec3> X)
{
  double energy = 0.0;
  const Springs& springs = network.springs;
  for (std::size_t n = 0; n < springs.a.size(); ++n) {
    const double l0 = springs.rest_length[n];
    const double stretch = norm(X[at(springs.b[n])] - X[at(springs.a[n])]) / l0 - 1.0;
    if (!is_slack(springs, n, stretch)) energy += 0.5 * springs.stiffness[n] * l0 * stretch * stretch;
  }
  const Beams& beams = network.beams;
  for (std::size_t n = 0; n < beams.x0.size(); ++n) {
    const Vec3 turn = Beam(beams, n).turn(X);
    energy += beams.rigidity[n] * dot(turn, turn) / (beams.l1[n] + beams.l2[n]);
  }
  const Tethers& tethers = network.tethers;
  for (std::size_t n = 0; n < tethers.node.size(); ++n) {
    const Vec3 away = tethers.target[n] - X[at(tethers.node[n])];
    energy += 0.5 * tethers.stiffness[n] * dot(away, away);
  }
  return energy;
}

void add_fibre_stiffness_times(const FibreNetwork& network, std::span<const Vec3> X, std::span<const Vec3> v,
                               std::span<Vec3> Kv, SlackSprings slack)
{
  const Springs& springs = network.springs;
  for (std::size_t n = 0; n < springs.a.size(); ++n) {
    const std::size_t a = at(springs.a[n]), b = at(springs.b[n]);
    const Vec3 r = X[b] - X[a];
    const double l = norm(r);
    const double stretch = l / springs.rest_length[n] - 1.0;
    const bool is_loose = is_slack(springs, n, stretch);
    if (l == 0.0 || (is_loose && slack == SlackSprings::loose)) continue;
    const double across = is_loose ? 0.0 : springs.stiffness[n] * stretch / l;
    const double along = springs.stiffness[n] / springs.rest_length[n];
    const Vec3 dv = v[b] - v[a];
    const Vec3 pull = ((along - across) * dot(r, dv) / (l * l)) * r + across * dv;
    Kv[a] -= pull;
    Kv[b] += pull;
  }
  add_beam_force(network.beams, v, -1.0, Kv);
  const Tethers& tethers = network.tethers;
  for (std::size_t n = 0; n < tethers.node.size(); ++n) {
    const std::size_t i = at(tethers.node[n]);
    Kv[i] += tethers.stiffness[n] * v[i];
  }
}

}  // namespace valsalva::ib3d
