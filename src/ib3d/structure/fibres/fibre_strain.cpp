#include "ib3d/structure/fibres/fibre_strain.hpp"

#include <algorithm>

#include "common/max_or_nan.hpp"

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
    if (tension_only) e = max_or_nan(e, 0.0);
    strain.mean += e;
    strain.largest = counted == 0 ? e : max_or_nan(strain.largest, e);
    ++counted;
  }
  if (counted > 0) strain.mean /= counted;
  return strain;
}

double largest_tether_displacement(const FibreNetwork& network, std::span<const Vec3> X,
                                   const NodeGroup& group)
{
  const Tethers& tethers = network.tethers;
  double largest = 0.0;
  for (std::size_t n = 0; n < tethers.node.size(); ++n) {
    if (!contains(group, tethers.node[n])) continue;
    const Vec3 away = tethers.target[n] - X[static_cast<std::size_t>(tethers.node[n])];
    largest = max_or_nan(largest, dot(away, away));
  }
  return std::sqrt(largest);
}

double largest_tether_displacement(const FibreNetwork& network, std::span<const Vec3> X)
{
  return largest_tether_displacement(network, X, NodeGroup{"", 0, network.node_count()});
}

const NodeGroup* find_group(const FibreNetwork& network, std::string_view name)
{
  const auto found = std::find_if(network.groups.begin(), network.groups.end(),
                                  [&](const NodeGroup& group) { return group.name == name; });
  return found == network.groups.end() ? nullptr : &*found;
}

}  // namespace valsalva::ib3d
