// Exchange of ghost values between the patches of one level, on one rank or across ranks, periodic images
// included.
//   fill        ghost <- value of the owner
//   accumulate  owner += ghost, the exact transpose of fill (ghosts are left as they are)
// Both are collective. The order of the copies is fixed, so results do not depend on message timing.
#pragma once

#include <mpi.h>

#include <vector>

#include "ib3d/grid/fields.hpp"

namespace valsalva::ib3d {

/// Where the values of one array sit: on the faces normal to x, y, z, or in cells.
enum class Centering { x_face = 0, y_face = 1, z_face = 2, cell = 3 };

class Halo {
 public:
  /// For groups of arrays with these centerings, exchanged in one message per neighbour rank.
  Halo(const Level& level, std::vector<Centering> centerings, int ghosts);

  static Halo for_cells(const Level& level, int ghosts) { return {level, {Centering::cell}, ghosts}; }
  static Halo for_faces(const Level& level, int ghosts = kMacGhosts)
  {
    return {level, {Centering::x_face, Centering::y_face, Centering::z_face}, ghosts};
  }

  template <class T>
  void fill(CellField<T>& field) const;
  void fill(MacField& field) const;
  void accumulate(MacField& field) const;

 private:
  /// The values `region` (indices of the owner) of array group `slot` belong at region + shift of another
  /// patch.
  struct Copy {
    int slot;
    int owner_patch, ghost_patch;  ///< local numbers where the patch is on this rank
    IndexBox region;
    Int3 shift;
  };
  /// Copies between this rank and another one; offsets follow the order of the list.
  struct Link {
    int rank = 0;
    std::vector<Copy> to_ghosts_there, to_ghosts_here;
    std::size_t send_size = 0, receive_size = 0;
  };
  template <class T, class At>
  void fill_arrays(At&& at) const;

  MPI_Comm comm_;
  std::vector<Copy> on_rank_;
  std::vector<Link> links_;
};

}  // namespace valsalva::ib3d
