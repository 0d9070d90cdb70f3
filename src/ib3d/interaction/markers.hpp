// Passive markers: points that the flow carries and that act on nothing, dX/dt = u(X, t), second order in dt
// (docs/scheme.md, 2.9):
//   X' = X^n + dt U^n,   U^{n+1} = J[X'] u^{n+1},   X^{n+1} = X^n + dt (U^n + U^{n+1})/2,   U = J[X] u at release
// Heun's method with the velocity kept that was found where the marker was expected: one interpolation per step. J is
// that of the finest level whose boxes hold the marker, and the marker lives on the rank of that box: it changes level
// and rank as it goes. A marker that leaves the domain is removed and counted. Order and ranks do not change where a
// marker goes by more than they change u. cm, s.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "common/checkpoint.hpp"
#include "ib3d/grid/fields.hpp"

namespace valsalva::ib3d {

/// Where and when the markers of one group are released.
struct MarkerSeed {
  std::string name;
  std::vector<Vec3> points;  ///< inside the domain, cm
  double start_s = 0;
  double every_s = 0;  ///< again at these intervals; 0: once
  double end_s = std::numeric_limits<double>::infinity();
};

struct Marker {
  Vec3 X;
  Vec3 U;            ///< velocity where it was expected at the end of the last step, cm/s
  double seeded_s;   ///< when it was released
  int id, group;     ///< id: its number in the order of release, the same on any number of ranks
  int level, patch;  ///< where it is; local number of the patch
};

class Markers {
 public:
  explicit Markers(std::vector<MarkerSeed> seeds);

  /// Whether any will ever be released: all that follows does nothing if not.
  bool wanted() const { return !seeds_.empty(); }
  const std::vector<MarkerSeed>& seeds() const { return seeds_; }
  /// This rank's.
  const std::vector<Marker>& local() const { return markers_; }
  /// How many have left the domain so far, the same on all ranks.
  int lost() const { return lost_; }
  /// How many have been released so far.
  int set_out() const { return next_id_; }
  /// All of them, by id, on every rank. Collective.
  std::vector<Marker> gather(MPI_Comm comm) const;

  /// Releases those that are due at time t, in the velocity u of that time, ghosts filled. The steps need not land
  /// on the seeds' times.
  void seed_due(const Hierarchy& grid, const CompositeMac& u, double t);
  /// Moves all over one step with the velocity u at its end, ghosts filled. Collective.
  void advance(const Hierarchy& grid, const CompositeMac& u, double dt);
  /// Reassigns level, patch and rank of all: after a step, or on another grid. Collective.
  void settle(const Hierarchy& grid);
  /// A case without markers leaves no trace in the file. Collective.
  void save_or_restore(Checkpoint& c, const Hierarchy& grid);

 private:
  void sort_by_patch(const Hierarchy& grid);
  /// U_ = J[X_] u, level by level.
  void interpolate(const Hierarchy& grid, const CompositeMac& u);

  std::vector<MarkerSeed> seeds_;
  std::vector<int> seedings_;  ///< per seed: how many of its times are over
  std::vector<Marker> markers_;
  std::vector<std::vector<int>> first_;  ///< markers of level l, patch p: first_[l][p] to first_[l][p + 1]
  std::vector<Vec3> X_, U_;
  int next_id_ = 0, lost_ = 0;
};

}  // namespace valsalva::ib3d
