#include "ib3d/structure/aortic_root.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "common/error.hpp"
#include "ib3d/structure/leaflet_lattice.hpp"
#include "ib3d/structure/root_wall.hpp"

namespace valsalva::ib3d {

namespace {

void append_shifted(const std::vector<int>& from, int shift, std::vector<int>& to)
{
  for (int node : from) to.push_back(node + shift);
}

template <class T>
void append(const std::vector<T>& from, std::vector<T>& to)
{
  to.insert(to.end(), from.begin(), from.end());
}

/// Appends the lattice at positions X, turned about the axis by `number` - 1 thirds.
void add_leaflet(const LeafletLattice& lattice, const std::vector<Vec3>& X, const RootDimensions& root,
                 int number, double edge_stiffness, AorticRoot& whole)
{
  FiberNetwork& network = whole.network;
  const FiberNetwork& one = lattice.network;
  const int first = network.node_count();
  const double angle = 2.0 * std::numbers::pi / 3.0 * (number - 1);
  const double c = std::cos(angle), s = std::sin(angle);
  for (std::size_t i = 0; i < X.size(); ++i) {
    const Vec3 turned{root.center[0] + c * X[i][0] - s * X[i][1], root.center[1] + s * X[i][0] + c * X[i][1],
                      X[i][2]};
    if (lattice.on_edge[i] != 0) {
      network.tethers.node.push_back(network.node_count());
      network.tethers.stiffness.push_back(edge_stiffness);
      network.tethers.target.push_back(turned);
    }
    network.X.push_back(turned);
  }
  append_shifted(one.springs.a, first, network.springs.a);
  append_shifted(one.springs.b, first, network.springs.b);
  append(one.springs.stiffness, network.springs.stiffness);
  append(one.springs.rest_length, network.springs.rest_length);
  append(one.springs.tension_only, network.springs.tension_only);
  append_shifted(one.beams.x0, first, network.beams.x0);
  append_shifted(one.beams.x1, first, network.beams.x1);
  append_shifted(one.beams.x2, first, network.beams.x2);
  append(one.beams.rigidity, network.beams.rigidity);
  append(one.beams.l1, network.beams.l1);
  append(one.beams.l2, network.beams.l2);
  network.groups.push_back(NodeGroup{"leaflet " + std::to_string(number), first, network.node_count()});
  network.free_edges.emplace_back();
  append_shifted(one.free_edges.front(), first, network.free_edges.back());
  for (const std::array<int, 3>& t : lattice.triangles)
    whole.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

}  // namespace

AorticRoot design_aortic_root(const RootDimensions& root, const LeafletMaterial& leaflets,
                              const WallMaterial& wall, double h)
{
  const std::vector<CaseProblem> problems = root_problems(root, leaflets, wall, h);
  if (!problems.empty()) throw CaseError(problems);

  const LeafletLattice lattice = leaflet_lattice(root, leaflets, h);
  const LeafletEquilibrium closed =
      find_leaflet_equilibrium(lattice, leaflets, kClosedPressure_mmHg, closed_leaflet_guess(root, lattice));
  const LeafletEquilibrium start =
      find_leaflet_equilibrium(lattice, leaflets, leaflets.start_pressure_mmHg, closed.X);

  AorticRoot whole;
  whole.closed = closed.shape;
  whole.start = start.shape;
  const double edge_stiffness = leaflets.edge_tether_ratio * wall.tether_stiffness * 0.25 * h * h;
  for (int number = 1; number <= 3; ++number)
    add_leaflet(lattice, start.X, root, number, edge_stiffness, whole);
  add_wall(root, wall, h, whole.network);
  return whole;
}

FiberNetwork build_aortic_root(const RootDimensions& root, const LeafletMaterial& leaflets,
                               const WallMaterial& wall, double h)
{
  return design_aortic_root(root, leaflets, wall, h).network;
}

}  // namespace valsalva::ib3d
