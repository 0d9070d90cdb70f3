// The grid: levels of disjoint boxes (patches) of cells, each owned by one MPI rank; every rank holds the
// same list. Level l has spacing h_0/2^l; the finest level covers every fibre node and its delta support.
// Boxes are aligned to the blocking factor of 8 cells and are as large as the number of ranks allows.
#pragma once

#include <mpi.h>

#include <array>
#include <vector>

#include "ib3d/grid/index_box.hpp"

namespace valsalva::ib3d {

inline constexpr int kBlockingFactor = 8;

/// What happens on one side of the domain. All sides allow no tangential velocity, except periodic ones.
///   wall      no penetration (discs of an `Opening` excepted)
///   open      zero normal traction: p = 0, any normal velocity
///   periodic  joined to the opposite side
enum class SideKind { wall, open, periodic };

/// Numbering of the six sides: x_lo, x_hi, y_lo, y_hi, z_lo, z_hi.
inline constexpr int kSideCount = 6;
constexpr int side_direction(int side)
{
  return side / 2;
}
constexpr bool side_is_high(int side)
{
  return side % 2 == 1;
}

/// The box [0, size] in cm.
struct Domain {
  Vec3 size{};
  std::array<SideKind, 6> sides{};
  bool periodic(int d) const { return sides[static_cast<std::size_t>(2 * d)] == SideKind::periodic; }
};

struct Patch {
  IndexBox box;
  int owner = 0;
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
  const IndexBox& local_box(int p) const
  {
    return patches[static_cast<std::size_t>(local[static_cast<std::size_t>(p)])].box;
  }
  long cell_count() const;
  /// Whether the box touches the side of the domain and the side is not periodic.
  bool at_side(const IndexBox& b, int side) const;
  /// Whether every patch can be halved in every direction.
  bool can_coarsen() const;
  /// The same boxes in cells twice as large, same owners.
  Level coarsened() const;
};

class Hierarchy {
 public:
  /// One level of spacing h (cm) covering the domain, cut into `boxes` boxes (at least one per rank).
  /// Throws CaseError("grid.finest_cm") when h does not divide the domain into multiples of 8 cells (to 0.5
  /// %).
  Hierarchy(const Domain& domain, double h, MPI_Comm comm, int boxes = 0);

  const Level& finest() const { return levels_.back(); }
  const std::vector<Level>& levels() const { return levels_; }

 private:
  std::vector<Level> levels_;
};

}  // namespace valsalva::ib3d
