#include "ib3d/structure/aortic_root/leaflet_fusion.hpp"

#include <cmath>
#include <limits>

#include "ib3d/structure/aortic_root/root_shape.hpp"

namespace valsalva::ib3d {

namespace {

constexpr double kFusedDepth = 0.25;  // of the commissure height, below the free edge

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

void mark_fused(const RootDimensions& root, double share_with_previous, double share_with_next,
                LeafletLattice& lattice)
{
  const double Ra = leaflet_half_width(root);
  for (std::size_t i = 0; i < lattice.s.size(); ++i) {
    const double s = lattice.s[i];
    const double share = s > 0.0 ? share_with_next : share_with_previous;
    const bool is_fused = s != 0.0 && std::abs(s) > (1.0 - share) * Ra &&
                          lattice.z[i] >= (1.0 - kFusedDepth) * root.commissure_height;
    if (is_fused && lattice.on_edge[i] == 0) lattice.fused_to[i] = s > 0.0 ? 1 : -1;
  }
}

void fuse_leaflets(const LeafletLattice& leaflet, int first_node, const LeafletLattice& next,
                   int first_node_of_next, double Kc, FibreNetwork& network)
{
  const double k = Kc * leaflet.row_distance / leaflet.column_distance;
  for (std::size_t i = 0; i < leaflet.s.size(); ++i) {
    if (leaflet.fused_to[i] != 1) continue;
    const int own = first_node + static_cast<int>(i);
    const int other = first_node_of_next + node_at(next, -leaflet.s[i], leaflet.z[i]);
    const double distance =
        norm(network.X[static_cast<std::size_t>(own)] - network.X[static_cast<std::size_t>(other)]);
    network.springs.add(own, other, k * distance, distance, false);
  }
}

}  // namespace valsalva::ib3d
