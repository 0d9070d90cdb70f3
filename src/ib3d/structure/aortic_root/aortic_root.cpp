#include "ib3d/structure/aortic_root/aortic_root.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "common/error.hpp"
#include "ib3d/structure/aortic_root/leaflet_fusion.hpp"
#include "ib3d/structure/aortic_root/leaflet_lattice.hpp"
#include "ib3d/structure/aortic_root/root_wall.hpp"

namespace valsalva::ib3d {

namespace {

/// Appends the lattice at positions X, turned about the axis by `number` - 1 thirds.
void add_leaflet(const LeafletLattice& lattice, const std::vector<Vec3>& X, const RootDimensions& root,
                 int number, double edge_stiffness, AorticRoot& whole)
{
  FibreNetwork& network = whole.network;
  const FibreNetwork& one = lattice.network;
  const int first = network.node_count();
  const double angle = 2.0 * std::numbers::pi / 3.0 * (number - 1);
  const double c = std::cos(angle), s = std::sin(angle);
  for (std::size_t i = 0; i < X.size(); ++i) {
    const Vec3 turned{root.centre[0] + c * X[i][0] - s * X[i][1], root.centre[1] + s * X[i][0] + c * X[i][1],
                      X[i][2]};
    if (lattice.on_edge[i] != 0) network.tethers.add(network.node_count(), edge_stiffness, turned);
    network.X.push_back(turned);
  }
  const Springs& springs = one.springs;
  for (std::size_t n = 0; n < springs.a.size(); ++n)
    network.springs.add(first + springs.a[n], first + springs.b[n], springs.stiffness[n],
                        springs.rest_length[n], springs.tension_only[n] != 0);
  const Beams& beams = one.beams;
  for (std::size_t n = 0; n < beams.x0.size(); ++n)
    network.beams.add({first + beams.x0[n], first + beams.x1[n], first + beams.x2[n]}, beams.rigidity[n],
                      beams.l1[n], beams.l2[n]);
  network.groups.push_back(NodeGroup{"leaflet " + std::to_string(number), first, network.node_count()});
  network.free_edges.emplace_back();
  for (int node : one.free_edges.front()) network.free_edges.back().push_back(first + node);
  for (const std::array<int, 3>& t : lattice.triangles)
    whole.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

struct FormedLeaflet {
  LeafletLattice lattice;
  LeafletShape closed;
  LeafletEquilibrium start;
};

FormedLeaflet form_leaflet(const RootDimensions& root, const LeafletMaterial& material, double h,
                           double fused_with_previous, double fused_with_next)
{
  FormedLeaflet formed;
  formed.lattice = leaflet_lattice(root, material, h);
  mark_fused(root, fused_with_previous, fused_with_next, formed.lattice);
  const LeafletEquilibrium closed = find_leaflet_equilibrium(formed.lattice, material, kClosedPressure_mmHg,
                                                             closed_leaflet_guess(root, formed.lattice));
  formed.closed = closed.shape;
  formed.start = find_leaflet_equilibrium(formed.lattice, material, material.start_pressure_mmHg, closed.X);
  return formed;
}

}  // namespace

AorticRoot design_aortic_root(const RootDimensions& root, const LeafletMaterial& leaflets,
                              const WallMaterial& wall, double h,
                              const std::array<LeafletFactors, 3>& factors)
{
  AorticRoot whole;
  const double edge_stiffness = leaflets.edge_tether_ratio * wall.tether_stiffness * 0.25 * h * h;
  std::array<FormedLeaflet, 3> formed;
  for (std::size_t n = 0; n < 3; ++n) {
    const LeafletFactors &previous = factors[(n + 2) % 3], &own = factors[n];
    const bool is_like_previous =
        n > 0 && own == previous && previous.fused_share == factors[(n + 1) % 3].fused_share;
    formed[n] = is_like_previous
                    ? formed[n - 1]
                    : form_leaflet(root, scaled(leaflets, own), h, previous.fused_share, own.fused_share);
    whole.closed[n] = formed[n].closed;
    whole.start[n] = formed[n].start.shape;
    add_leaflet(formed[n].lattice, formed[n].start.X, root, static_cast<int>(n) + 1, edge_stiffness, whole);
  }
  for (std::size_t n = 0; n < 3; ++n) {
    const std::size_t next = (n + 1) % 3;
    fuse_leaflets(formed[n].lattice, whole.network.groups[n].first, formed[next].lattice,
                  whole.network.groups[next].first, leaflets.circumferential_stiffness, whole.network);
  }
  add_wall(root, wall, h, whole.network);
  return whole;
}

FibreNetwork build_aortic_root(const RootDimensions& root, const LeafletMaterial& leaflets,
                               const WallMaterial& wall, double h)
{
  return design_aortic_root(root, leaflets, wall, h).network;
}

}  // namespace valsalva::ib3d
