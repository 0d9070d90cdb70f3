// A box of cells of one level: lo <= index < hi in each direction (hi exclusive), or empty.
#pragma once

#include <algorithm>
#include <vector>

#include "common/vec3.hpp"
#include "ib3d/grid/side.hpp"

namespace valsalva::ib3d {

struct IndexBox {
  Int3 lo{0, 0, 0};
  Int3 hi{0, 0, 0};

  bool operator==(const IndexBox&) const = default;
  int size(int d) const { return hi[static_cast<std::size_t>(d)] - lo[static_cast<std::size_t>(d)]; }
  bool empty() const { return size(0) <= 0 || size(1) <= 0 || size(2) <= 0; }
  long volume() const { return empty() ? 0 : static_cast<long>(size(0)) * size(1) * size(2); }

  bool contains(const Int3& c) const
  {
    return c[0] >= lo[0] && c[0] < hi[0] && c[1] >= lo[1] && c[1] < hi[1] && c[2] >= lo[2] && c[2] < hi[2];
  }
  /// By n cells on all sides.
  IndexBox grown(int n) const
  {
    return {{lo[0] - n, lo[1] - n, lo[2] - n}, {hi[0] + n, hi[1] + n, hi[2] + n}};
  }
  IndexBox shifted(const Int3& s) const
  {
    return {{lo[0] + s[0], lo[1] + s[1], lo[2] + s[2]}, {hi[0] + s[0], hi[1] + s[1], hi[2] + s[2]}};
  }
  /// Extended by n beyond a side.
  IndexBox extended(Side s, int n) const
  {
    IndexBox b = *this;
    (is_high(s) ? b.hi : b.lo)[static_cast<std::size_t>(axis(s))] -= n * inward(s);
    return b;
  }
  /// The indices [first, first + n) along direction d instead of the box's own.
  IndexBox with_range(int d, int first, int n) const
  {
    IndexBox b = *this;
    b.lo[static_cast<std::size_t>(d)] = first;
    b.hi[static_cast<std::size_t>(d)] = first + n;
    return b;
  }
  IndexBox shifted_back(const Int3& s) const { return shifted({-s[0], -s[1], -s[2]}); }
  /// Index along the axis of a side: of its faces, of the cells along it inside, and of the next ones outside.
  int faces_at(Side s) const { return (is_high(s) ? hi : lo)[static_cast<std::size_t>(axis(s))]; }
  int cells_inside(Side s) const { return faces_at(s) - (is_high(s) ? 1 : 0); }
  int cells_outside(Side s) const { return faces_at(s) - (is_high(s) ? 0 : 1); }
  /// The box of cells twice as large that cover this one; lo and hi must be even.
  IndexBox coarsened() const
  {
    return {{lo[0] / 2, lo[1] / 2, lo[2] / 2}, {hi[0] / 2, hi[1] / 2, hi[2] / 2}};
  }
  /// The same box in cells half as large.
  IndexBox refined() const { return {{2 * lo[0], 2 * lo[1], 2 * lo[2]}, {2 * hi[0], 2 * hi[1], 2 * hi[2]}}; }
};

/// floor(i/2), for negative indices too.
constexpr int half_below(int i)
{
  return i >> 1;
}

inline IndexBox intersect(const IndexBox& a, const IndexBox& b)
{
  IndexBox c;
  for (std::size_t d = 0; d < 3; ++d) {
    c.lo[d] = std::max(a.lo[d], b.lo[d]);
    c.hi[d] = std::max(c.lo[d], std::min(a.hi[d], b.hi[d]));
  }
  return c;
}

/// Calls f(i, j, k) for every index of the box, i fastest.
template <class F>
void for_each_index(const IndexBox& b, F&& f)
{
  for (int k = b.lo[2]; k < b.hi[2]; ++k)
    for (int j = b.lo[1]; j < b.hi[1]; ++j)
      for (int i = b.lo[0]; i < b.hi[0]; ++i) f(i, j, k);
}

/// Calls f(j, k) for every row (along x) of the box.
template <class F>
void for_each_row(const IndexBox& b, F&& f)
{
  for (int k = b.lo[2]; k < b.hi[2]; ++k)
    for (int j = b.lo[1]; j < b.hi[1]; ++j) f(j, k);
}

/// What is left of a box without another one: at most six disjoint boxes.
inline std::vector<IndexBox> without(IndexBox box, const IndexBox& hole)
{
  std::vector<IndexBox> rest;
  if (box.empty()) return rest;
  const IndexBox common = intersect(box, hole);
  if (common.empty()) return {box};
  for (std::size_t d : {2u, 1u, 0u}) {
    if (common.lo[d] > box.lo[d]) {
      rest.push_back(box);
      rest.back().hi[d] = common.lo[d];
    }
    if (common.hi[d] < box.hi[d]) {
      rest.push_back(box);
      rest.back().lo[d] = common.hi[d];
    }
    box.lo[d] = common.lo[d];
    box.hi[d] = common.hi[d];
  }
  return rest;
}

/// The same for a list of disjoint boxes.
inline std::vector<IndexBox> without(const std::vector<IndexBox>& boxes, const IndexBox& hole)
{
  std::vector<IndexBox> rest;
  for (const IndexBox& b : boxes)
    for (const IndexBox& piece : without(b, hole)) rest.push_back(piece);
  return rest;
}

}  // namespace valsalva::ib3d
