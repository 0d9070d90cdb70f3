// Which rank computes which node: the owner of the finest box under it. Each rank keeps its own nodes, sorted
// by patch and cell, and copies of those that its elements join to them. The whole model is on every rank.
#pragma once

#include <string>
#include <vector>

#include "common/checkpoint.hpp"
#include "ib3d/grid/hierarchy.hpp"
#include "ib3d/structure/elastic_model.hpp"

namespace valsalva::ib3d {

class NodeDistribution {
 public:
  /// Distributes the nodes of `whole` from its start positions over the patches of a level, which must outlive the object
  /// or be followed by another (`move_to`). Collective.
  NodeDistribution(std::unique_ptr<const ElasticModel> whole, const Level& level);

  const ElasticModel& whole() const { return *whole_; }
  /// What acts on this rank's nodes. Forces on copies are incomplete.
  const ElasticModel& part() const { return *part_; }
  /// Numbers in the whole of the local nodes: this rank's own, then the copies.
  const std::vector<int>& global() const { return global_; }
  /// Where the local nodes were when they were distributed, cm.
  const std::vector<Vec3>& X() const { return X_; }
  /// Nodes of local patch p are [first()[p], first()[p+1]); first().back() is the number of owned nodes.
  const std::vector<int>& first() const { return first_; }
  /// Number of nodes of this rank; they come first.
  int owned() const { return first_.back(); }

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
  /// Assigns every node to its patch anew; the new local positions are X(). Collective. Throws SolverError when a node has
  /// left the domain by more than the drift.
  void redistribute(const std::vector<Vec3>& X) { distribute(gather(X)); }
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

  std::unique_ptr<const ElasticModel> whole_, part_;
  const Level* level_;
  std::vector<int> global_;
  std::vector<Vec3> X_;
  std::vector<int> first_;
  std::vector<int> local_number_;  ///< of every node: its number here if it is owned, else -1
  struct Link {
    int rank;
    std::vector<int> local_nodes;
  };
  std::vector<Link> sends_, receives_;
};

}  // namespace valsalva::ib3d
