// Which rank computes which node: the owner of the finest box under it. Each rank keeps its own nodes, sorted
// by patch and cell, and copies of the neighbours that its springs and beams need. The topology
// (FibreNetwork) is replicated.
#pragma once

#include <string>
#include <vector>

#include "common/checkpoint.hpp"
#include "ib3d/grid/hierarchy.hpp"
#include "ib3d/structure/fibres/fibre_network.hpp"

namespace valsalva::ib3d {

class NodeDistribution {
 public:
  /// Distributes the nodes of `whole` from its start positions. Collective.
  NodeDistribution(FibreNetwork whole, const Level& level);

  const FibreNetwork& whole() const { return whole_; }
  const FibrePart& part() const { return part_; }
  /// Nodes of local patch p are [first()[p], first()[p+1]); first().back() is the number of owned nodes.
  const std::vector<int>& first() const { return first_; }
  /// Number of nodes of this rank; they come first.
  int owned() const { return part_.owned; }

  /// Copies values of owned nodes to the ranks that hold copies; `values` has one entry per local node.
  /// Collective.
  void fill_copies(std::vector<Vec3>& values) const;
  /// Values of all nodes, in global order, on every rank, from those of the owned ones. Collective.
  std::vector<Vec3> gather(const std::vector<Vec3>& values) const;
  /// The same for a few nodes (global numbers) only. Collective.
  std::vector<Vec3> gather(const std::vector<Vec3>& values, const std::vector<int>& nodes) const;

  /// How far (cells, along any direction) the farthest node of this rank lies outside its patch, negative where all lie
  /// inside; infinite for one that is not a number. More than kNodeDrift: time to redistribute. Local.
  double farthest_out(const std::vector<Vec3>& X) const;
  /// Assigns every node to its patch anew and returns the new local positions, copies included. Collective.
  /// Throws SolverError when a node has left the domain by more than the drift.
  std::vector<Vec3> redistribute(const std::vector<Vec3>& X);
  /// Distributes the nodes, at X (all of them, in global order), over the patches of another level. Collective.
  void move_to(const Level& level, const std::vector<Vec3>& X);

  /// The positions at which the nodes were last distributed: from them the same ranks find the same order of
  /// nodes, and sums over nodes repeat bit for bit. Collective.
  void save_or_restore(Checkpoint& c);
  /// Values of the nodes, in global order in the file. Collective.
  void save_or_restore(Checkpoint& c, const std::string& name, std::vector<Vec3>& values) const;

 private:
  void distribute(const std::vector<Vec3>& X_global);
  void plan_copies(const std::vector<int>& owner);

  FibreNetwork whole_;
  Level level_;
  FibrePart part_;
  std::vector<int> first_;
  std::vector<int> local_number_;  ///< of every node: its number here if it is owned, else -1
  struct Link {
    int rank;
    std::vector<int> local_nodes;
  };
  std::vector<Link> sends_, receives_;
};

}  // namespace valsalva::ib3d
