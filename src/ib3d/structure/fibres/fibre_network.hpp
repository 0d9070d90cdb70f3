// The immersed elastic structure: nodes joined by springs and beams and held by tethers, as structure of
// arrays. Massless and neutrally buoyant; forces are nodal (dyn), positions in cm.
//   spring   T = stiffness (l/l0 - 1) along the line a-b; stiffness in dyn; tension-only springs have T >= 0
//   beam     E = rigidity |(X2 - X1)/l2 - (X1 - X0)/l1|^2 / (l1 + l2), rigidity in dyn cm^2, l1, l2 the
//            reference lengths of its two sides (cm): second order on unevenly spaced nodes
//   tether   F = stiffness (target - X), stiffness in dyn/cm
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ib3d/structure/elastic_model.hpp"

namespace valsalva::ib3d {

/// One entry per spring: node numbers, dyn, cm.
struct Springs {
  std::vector<int> a, b;
  std::vector<double> stiffness, rest_length;
  std::vector<std::uint8_t> tension_only;
  void add(int from, int to, double k, double l0, bool pulls_only)
  {
    a.push_back(from);
    b.push_back(to);
    stiffness.push_back(k);
    rest_length.push_back(l0);
    tension_only.push_back(pulls_only ? 1 : 0);
  }
  int count() const { return static_cast<int>(a.size()); }
};

/// One entry per beam: node numbers, x1 in the middle; dyn cm^2, cm.
struct Beams {
  std::vector<int> x0, x1, x2;
  std::vector<double> rigidity, l1, l2;
  void add(const std::array<int, 3>& nodes, double c, double length_before, double length_after)
  {
    x0.push_back(nodes[0]);
    x1.push_back(nodes[1]);
    x2.push_back(nodes[2]);
    rigidity.push_back(c);
    l1.push_back(length_before);
    l2.push_back(length_after);
  }
  int count() const { return static_cast<int>(x0.size()); }
};

/// One entry per tether: node number, dyn/cm, cm.
struct Tethers {
  std::vector<int> node;
  std::vector<double> stiffness;
  std::vector<Vec3> target;
  void add(int held, double k, const Vec3& at)
  {
    node.push_back(held);
    stiffness.push_back(k);
    target.push_back(at);
  }
  int count() const { return static_cast<int>(node.size()); }
};

/// The whole structure, or one rank's part of it (`FibreModel::part`).
struct FibreNetwork {
  std::vector<Vec3> X;  ///< node positions at the start, cm
  Springs springs;
  Beams beams;
  Tethers tethers;
  std::vector<NodeGroup> groups;
  std::vector<std::vector<int>> free_edges;  ///< per leaflet, node numbers from commissure to commissure
  int node_count() const { return static_cast<int>(X.size()); }
};

}  // namespace valsalva::ib3d
