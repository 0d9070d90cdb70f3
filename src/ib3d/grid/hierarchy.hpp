// The grid: levels of disjoint boxes (patches) of cells, each owned by one MPI rank; every rank holds the
// same list. Level l has spacing h_0/2^l; level 0 covers the domain, the finest level every fibre node and its
// delta support. Boxes are as large as the number of ranks allows, aligned to the blocking factor of 8 cells,
// on level 0 of 4. Ranks are given regions of space, the same on all levels up to this alignment.
#pragma once

#include <mpi.h>

#include <array>
#include <vector>

#include "ib3d/grid/index_box.hpp"

namespace valsalva::ib3d {

inline constexpr int kBlockingFactor = 8;
inline constexpr int kCoarsestBlockingFactor = 4;

/// What happens on one side of the domain. All sides allow no tangential velocity, except periodic ones.
///   wall      no penetration (discs of an `Opening` excepted)
///   open      zero normal traction: p = 0, any normal velocity
///   periodic  joined to the opposite side
enum class SideKind { wall, open, periodic };

/// The box [0, size] in cm.
struct Domain {
  Vec3 size{};
  std::array<SideKind, 6> sides{};  ///< in the order of Side
  SideKind kind(Side s) const { return sides[static_cast<std::size_t>(s)]; }
  bool periodic(int d) const { return sides[static_cast<std::size_t>(2 * d)] == SideKind::periodic; }
};

/// Cells of its level, the rank that computes them, and its number among the patches of this rank, -1 on the others.
struct Patch {
  IndexBox box;
  int owner = 0;
  int local = -1;
};

/// One level: all cells have spacing h (cm). `local` lists the patches of this rank; fields are stored in
/// that order.
struct Level {
  double h = 0;
  IndexBox box;  ///< the whole domain in cells of this level
  Domain domain;
  std::vector<Patch> patches;
  std::vector<int> local;
  MPI_Comm comm = MPI_COMM_SELF;

  int local_count() const { return static_cast<int>(local.size()); }
  /// Number of local patch p in `patches`.
  std::size_t number_of(int p) const { return static_cast<std::size_t>(local[static_cast<std::size_t>(p)]); }
  const IndexBox& local_box(int p) const { return patches[number_of(p)].box; }
  /// The patch that holds a cell, or null.
  const Patch* patch_at(const Int3& cell) const;
  /// Of all patches on all ranks.
  long cell_count() const;
  /// Whether the box touches the side of the domain and the side is not periodic.
  bool at_side(const IndexBox& b, Side side) const;
  /// `values`, indices of a patch with these cells, and `reach` more beyond the sides of the domain that it touches.
  IndexBox with_outside(const IndexBox& cells, IndexBox values, int reach) const;
  /// Whether every patch can be halved in every direction.
  bool can_coarsen() const;
  /// The same boxes in cells twice as large, same owners.
  Level coarsened() const;
};

/// Boxes of the refined levels, in cells of each: refinement[l - 1] are those of level l.
using Refinement = std::vector<std::vector<IndexBox>>;

class Hierarchy {
 public:
  /// One level of spacing h (cm) covering the domain, cut into `boxes` boxes (at least one per rank).
  /// Throws CaseError("grid.finest_cm") when h does not divide the domain into multiples of 4 cells of the
  /// coarsest level (to 0.5 %).
  Hierarchy(const Domain& domain, double h, MPI_Comm comm, int boxes = 0);
  /// Levels 0 to refinement.size() with spacing h on the finest. Each level's boxes must be disjoint, aligned, and
  /// lie inside the next coarser level with the nesting buffer. A node costs as much as kNodeWeight cells when the
  /// ranks' regions are chosen; `nodes` are positions in cm.
  Hierarchy(const Domain& domain, double h, MPI_Comm comm, const Refinement& refinement,
            const std::vector<Vec3>& nodes = {}, int boxes = 0);

  const Level& finest() const { return levels_.back(); }
  const std::vector<Level>& levels() const { return levels_; }
  int level_count() const { return static_cast<int>(levels_.size()); }
  const Level& level(int l) const { return levels_[static_cast<std::size_t>(l)]; }
  MPI_Comm comm() const { return levels_[0].comm; }
  const Domain& domain() const { return levels_[0].domain; }
  /// The boxes it was made of, before they were cut for the ranks.
  const Refinement& refinement() const { return refinement_; }
  /// Cells that no finer level covers.
  long valid_cell_count() const;
  /// Whether level l + 1 covers this cell of level l.
  bool covered(int l, const Int3& cell) const;

 private:
  std::vector<Level> levels_;
  Refinement refinement_;
};

/// Cells along each direction of the coarsest of `levels` levels, the finest of spacing h: or a CaseError that names
/// spacings that would do.
Int3 coarsest_cells(const Domain& domain, double h, int levels);

/// The spacing (cm) of the finest level that this makes of h.
double finest_spacing(const Domain& domain, double h, int levels);

}  // namespace valsalva::ib3d
