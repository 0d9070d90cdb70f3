#include "ib3d/structure/fibres/fibre_strain.hpp"

#include <algorithm>

namespace valsalva::ib3d {

namespace {

bool contains(const NodeGroup& group, int node)
{
  return node >= group.first && node < group.last;
}

}  // namespace

Strain fibre_strain(const FibreNetwork& network, std::span<const Vec3> X, const NodeGroup& group,
                    SpringFamily family)
{
  const Springs& springs = network.springs;
  Strain strain;
  int counted = 0;
  for (std::size_t n = 0; n < springs.a.size(); ++n) {
    if (!contains(group, springs.a[n]) || !contains(group, springs.b[n])) continue;
    const bool tension_only = springs.tension_only[n] != 0;
    if (family == SpringFamily::tension_only && !tension_only) continue;
    if (family == SpringFamily::two_sided && tension_only) continue;
    const auto a = static_cast<std::size_t>(springs.a[n]), b = static_cast<std::size_t>(springs.b[n]);
    double e = norm(X[b] - X[a]) / springs.rest_length[n] - 1.0;
    if (tension_only) e = std::max(e, 0.0);
    strain.mean += e;
    strain.largest = counted == 0 ? e : std::max(strain.largest, e);
    ++counted;
  }
  if (std::isnan(strain.mean)) strain.largest = strain.mean;  // a maximum loses a NaN, a sum does not
  if (counted > 0) strain.mean /= counted;
  return strain;
}

double largest_tether_displacement(const FibreNetwork& network, std::span<const Vec3> X)
{
  const Tethers& tethers = network.tethers;
  double largest = 0.0, sum = 0.0;
  for (std::size_t n = 0; n < tethers.node.size(); ++n) {
    const Vec3 away = tethers.target[n] - X[static_cast<std::size_t>(tethers.node[n])];
    largest = std::max(largest, dot(away, away));
    sum += dot(away, away);
  }
  return std::isnan(sum) ? sum : std::sqrt(largest);
}

}  // namespace valsalva::ib3d
