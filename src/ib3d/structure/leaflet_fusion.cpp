#include "ib3d/structure/leaflet_fusion.hpp"

#include <cmath>
#include <limits>

namespace valsalva::ib3d {

namespace {

constexpr double kGrownTogether = 0.1;  // cm

/// The inner node of `lattice` nearest to the reference coordinates (s, z).
int node_at(const LeafletLattice& lattice, double s, double z)
{
  int nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < lattice.s.size(); ++i) {
    const double distance = std::hypot(lattice.s[i] - s, lattice.z[i] - z);
    if (lattice.on_edge[i] == 0 && distance < least) {
      nearest = static_cast<int>(i);
      least = distance;
    }
  }
  return nearest;
}

}  // namespace

void fuse_leaflets(const LeafletLattice& a, int first_a, const LeafletLattice& b, int first_b, double s_from,
                   double Kc, FiberNetwork& network)
{
  const double free_edge_z = a.z[static_cast<std::size_t>(a.network.free_edges.front().front())];
  const double k = Kc * a.row_distance / a.column_distance;
  for (std::size_t i = 0; i < a.s.size(); ++i) {
    if (a.on_edge[i] != 0 || a.s[i] < s_from) continue;
    const int own = first_a + static_cast<int>(i);
    const int other = first_b + node_at(b, -a.s[i], a.z[i]);
    const double distance =
        norm(network.X[static_cast<std::size_t>(own)] - network.X[static_cast<std::size_t>(other)]);
    if (a.z[i] < free_edge_z && distance > kGrownTogether) continue;
    network.springs.a.push_back(own);
    network.springs.b.push_back(other);
    network.springs.stiffness.push_back(k * distance);
    network.springs.rest_length.push_back(distance);
    network.springs.tension_only.push_back(0);
  }
}

}  // namespace valsalva::ib3d
