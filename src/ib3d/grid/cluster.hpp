// From tagged tiles (cubes of 8 cells of one level) to few large boxes that hold them: boxes are shrunk onto their
// tags and cut, at a plane without tags or where the number of tags per plane changes most (Berger & Rigoutsos 1991),
// until they are full enough; then boxes that make up a larger box are merged.
#pragma once

#include <cstdint>
#include <vector>

#include "ib3d/grid/hierarchy.hpp"

namespace valsalva::ib3d {

/// Tags on the tiles of a level.
class Tiles {
 public:
  /// No tags yet; `cells` is a level's whole box, a multiple of 8 cells in every direction.
  explicit Tiles(const IndexBox& cells);
  const IndexBox& box() const { return box_; }  ///< in tiles
  bool operator()(int i, int j, int k) const { return tag_[index(i, j, k)] != 0; }
  void set(int i, int j, int k) { tag_[index(i, j, k)] = 1; }
  /// Tags the tiles that hold cells of this box, as far as they lie in the domain; periodic images too.
  void add(const IndexBox& cells, const Domain& domain);
  /// Tags, in every layer of tiles across z, what the tags there enclose (joined by faces); not across periodic sides.
  void fill_enclosed();

 private:
  std::size_t index(int i, int j, int k) const
  {
    return static_cast<std::size_t>(i + box_.hi[0] * (j + static_cast<long>(box_.hi[1]) * k));
  }
  IndexBox box_;
  std::vector<std::uint8_t> tag_;
};

/// Disjoint boxes (in cells) that hold all tagged tiles; at least `efficiency` of each is tagged.
std::vector<IndexBox> cluster(const Tiles& tags, double efficiency = 0.8);

}  // namespace valsalva::ib3d
