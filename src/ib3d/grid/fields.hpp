// Fields on one level: contiguous storage per local patch, ghosts included, i fastest.
//   Array3      one scalar on the indices of a stored box
//   CellField   one scalar per cell: pressure (dyn/cm^2), divergence (1/s), ...
//   MacField    one vector component per face: velocity (cm/s) or force density (dyn/cm^3); component d sits on
//               the faces normal to d, face index i being the low face of cell i
// All arrays of a patch have the same shape (the box grown by the ghosts, one more at the high end), so that
// one linear index serves the three components and the cells in the kernels. Ghosts are valid only after they
// have been filled. A patch owns its low faces; its high faces belong to the neighbour, or to itself where there
// is none.
#pragma once

#include <cstddef>
#include <vector>

#include "ib3d/grid/overlap.hpp"

namespace valsalva::ib3d {

/// Ghost layers of velocities: 4 for the widest flux (xsPPM7); 2 for the delta support and 1 for drifting nodes.
inline constexpr int kMacGhosts = 4;
/// Those that the delta function reads and writes between patches.
inline constexpr int kNodeGhosts = 3;

template <class T>
/// Indices are the level's own, global ones; the box `stored` holds the ghosts too.
class Array3 {
 public:
  Array3() = default;
  explicit Array3(const IndexBox& stored)
      : stored_(stored),
        stride_y_(stored.size(0)),
        stride_z_(static_cast<std::ptrdiff_t>(stored.size(0)) * stored.size(1)),
        data_(static_cast<std::size_t>(stored.volume()), T{})
  {
  }
  const IndexBox& stored() const { return stored_; }
  /// Place of index (i, j, k) in `data`.
  std::ptrdiff_t offset(int i, int j, int k) const
  {
    return (i - stored_.lo[0]) + (j - stored_.lo[1]) * stride_y_ + (k - stored_.lo[2]) * stride_z_;
  }
  T& operator()(int i, int j, int k) { return data_[static_cast<std::size_t>(offset(i, j, k))]; }
  T operator()(int i, int j, int k) const { return data_[static_cast<std::size_t>(offset(i, j, k))]; }
  /// Address of index (i, j, k), for kernels that walk along x.
  T* at(int i, int j, int k) { return data_.data() + offset(i, j, k); }
  const T* at(int i, int j, int k) const { return data_.data() + offset(i, j, k); }
  /// Distance in memory between neighbours along direction d.
  std::ptrdiff_t stride(int d) const { return d == 0 ? 1 : d == 1 ? stride_y_ : stride_z_; }
  void set_zero() { data_.assign(data_.size(), T{}); }
  std::vector<T>& data() { return data_; }
  const std::vector<T>& data() const { return data_; }

 private:
  IndexBox stored_;
  std::ptrdiff_t stride_y_ = 0, stride_z_ = 0;
  std::vector<T> data_;
};

/// What a patch stores: its cells, the ghosts, and one more at the high end for the faces.
inline IndexBox stored_box(const IndexBox& cells, int ghosts)
{
  IndexBox b = cells.grown(ghosts);
  for (int& h : b.hi) ++h;
  return b;
}

/// Number p is that of a local patch, as in Level::local.
template <class T>
class CellField {
 public:
  using Value = T;
  CellField() = default;
  explicit CellField(const Level& level, int ghosts = 1) : ghosts_(ghosts)
  {
    for (int p = 0; p < level.local_count(); ++p) patch_.emplace_back(stored_box(level.local_box(p), ghosts));
  }
  int ghosts() const { return ghosts_; }
  int patch_count() const { return static_cast<int>(patch_.size()); }
  Array3<T>& operator[](int p) { return patch_[static_cast<std::size_t>(p)]; }
  const Array3<T>& operator[](int p) const { return patch_[static_cast<std::size_t>(p)]; }
  Array3<T>& operator()(int p, Centring) { return (*this)[p]; }
  const Array3<T>& operator()(int p, Centring) const { return (*this)[p]; }
  void set_zero()
  {
    for (Array3<T>& a : patch_) a.set_zero();
  }

 private:
  int ghosts_ = 0;
  std::vector<Array3<T>> patch_;
};

class MacField {
 public:
  using Value = double;
  MacField() = default;
  explicit MacField(const Level& level, int ghosts = kMacGhosts)
      : component_{CellField<double>(level, ghosts), CellField<double>(level, ghosts),
                   CellField<double>(level, ghosts)}
  {
  }
  int ghosts() const { return component_[0].ghosts(); }
  int patch_count() const { return component_[0].patch_count(); }
  /// Component d on local patch p.
  Array3<double>& operator()(int p, int d) { return component_[static_cast<std::size_t>(d)][p]; }
  const Array3<double>& operator()(int p, int d) const { return component_[static_cast<std::size_t>(d)][p]; }
  Array3<double>& operator()(int p, Centring face) { return (*this)(p, static_cast<int>(face)); }
  const Array3<double>& operator()(int p, Centring face) const { return (*this)(p, static_cast<int>(face)); }
  void set_zero()
  {
    for (auto& c : component_) c.set_zero();
  }

 private:
  std::array<CellField<double>, 3> component_;
};

/// The values that a patch of the level owns: its cells; or its low faces, and those of its high faces that are no
/// patch's low faces, at sides of the domain and of the level.
inline std::vector<IndexBox> owned_boxes(const Level& level, const IndexBox& cells, Centring c)
{
  std::vector<IndexBox> boxes{cells};
  if (c == Centring::cell) return boxes;
  const int d = static_cast<int>(c);
  for (const IndexBox& high :
       uncovered({cells.with_range(d, cells.hi[static_cast<std::size_t>(d)], 1)}, level))
    boxes.push_back(high);
  return boxes;
}

/// Calls f(i, j, k) for every face normal to d that local patch p owns.
template <class F>
void for_each_owned_face(const Level& level, int p, int d, F&& f)
{
  for (const IndexBox& b : owned_boxes(level, level.local_box(p), face_normal_to(d))) for_each_index(b, f);
}

/// Calls f(p, d, i, j, k, n) for the first face (i, j, k) and the length of every row of faces of the local patches, high
/// faces included.
template <class F>
void for_each_face_row(const Level& level, F&& f)
{
  for (int p = 0; p < level.local_count(); ++p)
    for (int d = 0; d < 3; ++d) {
      const IndexBox box = faces_of(level.local_box(p), d);
      for_each_row(box, [&](int j, int k) { f(p, d, box.lo[0], j, k, box.size(0)); });
    }
}

/// One field per level, coarsest first.
template <class T>
using CompositeCells = std::vector<CellField<T>>;
using CompositeMac = std::vector<MacField>;

/// Zero everywhere, ghosts included.
template <class T>
CompositeCells<T> composite_cells(const Hierarchy& grid)
{
  CompositeCells<T> fields;
  for (const Level& level : grid.levels()) fields.emplace_back(level);
  return fields;
}

/// Zero everywhere, ghosts included.
inline CompositeMac composite_faces(const Hierarchy& grid)
{
  CompositeMac fields;
  for (const Level& level : grid.levels()) fields.emplace_back(level);
  return fields;
}

}  // namespace valsalva::ib3d
