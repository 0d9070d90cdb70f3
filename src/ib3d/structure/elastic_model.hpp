// The immersed structure as the solver sees it: massless nodes that act on the fluid through an energy E(X),
//     F = -dE/dX [dyn],    K = -dF/dX,    K v [dyn, v in cm]
// Arrays are contiguous with one entry per node (cm, cm/s, dyn); a call works on all nodes, none is made per node. The
// nodes are coupled in elements: the share of an element in E depends on its own nodes alone. From this graph
// NodeDistribution chooses what a rank computes, and `part` makes the model of it. Members: FibreModel.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "common/vec3.hpp"

namespace valsalva::ib3d {

/// Lists of nodes: element e joins those from nodes[first[e]] to nodes[first[e + 1] - 1].
struct Elements {
  std::vector<int> first{0}, nodes;
  void add(std::span<const int> of_one)
  {
    nodes.insert(nodes.end(), of_one.begin(), of_one.end());
    first.push_back(static_cast<int>(nodes.size()));
  }
  int count() const { return static_cast<int>(first.size()) - 1; }
  std::span<const int> operator[](int e) const
  {
    const int* begin = nodes.data() + first[static_cast<std::size_t>(e)];
    return {begin, nodes.data() + first[static_cast<std::size_t>(e) + 1]};
  }
};

/// Some elements of a model and all nodes that they join.
struct Selection {
  std::vector<int> elements;  ///< in the order of the whole
  std::vector<int> nodes;     ///< node i of the part is nodes[i] of the whole
  std::vector<int> number;    ///< of every node of the whole in the part, or -1
};

/// Every element that touches one of the nodes `owned`, so that forces on these are complete, and to the last bit the
/// whole's if added in the order of the elements. The nodes are `owned`, as given, then the others in the order of their
/// first use.
Selection touching(const Elements& elements, int node_count, std::span<const int> owned);

/// Nodes [first, last) that belong together, e.g. "wall", "leaflet 1".
struct NodeGroup {
  std::string name;
  int first = 0, last = 0;
};

/// Largest strain of an element, and largest distance of a tethered node from its target, cm; NaN where a position is.
struct Deformation {
  double largest_strain = 0, largest_displacement = 0;
};

/// Elements as they are drawn, lines or triangles, with their strains.
struct StrainedElements {
  Elements elements;
  std::vector<double> strain;
};

class ElasticModel {
 public:
  virtual ~ElasticModel() = default;

  /// Positions of all nodes at the start, cm.
  virtual const std::vector<Vec3>& start() const = 0;
  int node_count() const { return static_cast<int>(start().size()); }
  virtual const std::vector<NodeGroup>& groups() const = 0;

  /// F += -dE/dX at the positions X.
  virtual void add_force(std::span<const Vec3> X, std::span<Vec3> F) const = 0;
  /// E at X, erg.
  virtual double energy(std::span<const Vec3> X) const = 0;
  /// Kv += K v at X, where what is slack but may be taut in the next instant counts as taut: for the stable step.
  virtual void add_stiffness_times(std::span<const Vec3> X, std::span<const Vec3> v,
                                   std::span<Vec3> Kv) const = 0;
  /// U += the velocity of the nodes relative to the fluid in a step dt (s); most models have none.
  virtual void add_slip(std::span<const Vec3> /*X*/, double /*dt*/, std::span<Vec3> /*U*/) const {}

  /// The graph of what is coupled.
  virtual Elements elements() const = 0;
  /// These elements alone, on these nodes; without groups.
  virtual std::unique_ptr<const ElasticModel> part(const Selection& selection) const = 0;

  virtual Deformation deformation(std::span<const Vec3> X) const = 0;
  virtual StrainedElements drawing(std::span<const Vec3> X) const = 0;
};

}  // namespace valsalva::ib3d
