#include "ib3d/grid/recursive_bisection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/error.hpp"

namespace valsalva::ib3d {

namespace {

/// A box of the grid in cm, and its cells.
struct Block {
  Vec3 lo, hi;
  double work;
};

double overlap(const Block& b, int d, double below)
{
  return b.work * std::clamp((below - b.lo[d]) / (b.hi[d] - b.lo[d]), 0.0, 1.0);
}

}  // namespace

/// What lies in a part of space.
struct RecursiveBisection::Part {
  /// Around the boxes of one level, cm.
  struct Extent {
    Vec3 lo, hi;
    double block;
    int blocks(int d) const { return static_cast<int>(std::lround((hi[d] - lo[d]) / block)); }
    int longest() const
    {
      int d = 2;
      for (int e : {1, 0})
        if (hi[e] - lo[e] > hi[d] - lo[d] + 1e-9) d = e;
      return d;
    }
  };
  std::vector<Block> blocks;  ///< of all levels
  std::vector<Vec3> nodes;
  std::vector<Extent> extents;  ///< finest level first

  double work_below(int d, double x) const
  {
    double work = 0;
    for (const Block& b : blocks) work += overlap(b, d, x);
    for (const Vec3& n : nodes) work += n[d] < x ? kNodeWeight : 0.0;
    return work;
  }
  Part side(int d, double x, bool high) const
  {
    Part part;
    for (Block b : blocks) {
      const double below = overlap(b, d, x);
      b.work = high ? b.work - below : below;
      (high ? b.lo : b.hi)[d] = high ? std::max(b.lo[d], x) : std::min(b.hi[d], x);
      if (b.hi[d] > b.lo[d]) part.blocks.push_back(b);
    }
    for (const Vec3& n : nodes)
      if ((n[d] >= x) == high) part.nodes.push_back(n);
    part.extents = extents;
    for (Extent& e : part.extents)
      (high ? e.lo : e.hi)[d] = high ? std::max(e.lo[d], x) : std::min(e.hi[d], x);
    return part;
  }
};

RecursiveBisection::RecursiveBisection(const std::vector<LevelBoxes>& levels, const std::vector<Vec3>& nodes,
                                       int count)
{
  Part all;
  all.nodes = nodes;
  for (std::size_t l = levels.size(); l-- > 0;) {
    const LevelBoxes& level = levels[l];
    Part::Extent around{{}, {}, level.block * level.h};
    for (const IndexBox& box : level.boxes) {
      Block b{{}, {}, static_cast<double>(box.volume())};
      for (int d = 0; d < 3; ++d) {
        b.lo[d] = box.lo[static_cast<std::size_t>(d)] * level.h;
        b.hi[d] = box.hi[static_cast<std::size_t>(d)] * level.h;
        const bool first = &box == level.boxes.data();
        around.lo[d] = first ? b.lo[d] : std::min(around.lo[d], b.lo[d]);
        around.hi[d] = first ? b.hi[d] : std::max(around.hi[d], b.hi[d]);
      }
      all.blocks.push_back(b);
    }
    if (!level.boxes.empty()) all.extents.push_back(around);
  }
  split(std::move(all), 0, count);
}

int RecursiveBisection::split(Part part, int first, int count)
{
  const int number = static_cast<int>(nodes_.size());
  nodes_.push_back({first, count});
  if (count == 1) return number;
  // Across the longest side of the finest level, or of a coarser one where that is a single block.
  const auto can_be_cut = [](const Part::Extent& e) { return e.blocks(e.longest()) >= 2; };
  const auto found = std::find_if(part.extents.begin(), part.extents.end(), can_be_cut);
  if (found == part.extents.end())
    throw CaseError("grid.finest_cm",
                    fmt::format("leaves too few cells to share among {} boxes; run on fewer ranks", count));
  const Part::Extent extent = *found;
  const int d = extent.longest(), blocks = extent.blocks(d);
  const int low_count = count / 2;
  const double wanted = part.work_below(d, std::numeric_limits<double>::max()) * low_count / count;
  double best = 0, best_off = -1;
  for (int b = 1; b < blocks; ++b) {
    const double x = extent.lo[d] + b * extent.block, off = std::abs(part.work_below(d, x) - wanted);
    if (best_off < 0 || off < best_off - 1e-9 * wanted) {
      best = x;
      best_off = off;
    }
  }
  const int low = split(part.side(d, best, false), first, low_count);
  const int high = split(part.side(d, best, true), first + low_count, count - low_count);
  nodes_[static_cast<std::size_t>(number)] = {first, count, d, best, low, high};
  return number;
}

std::vector<RecursiveBisection::Piece> RecursiveBisection::cut(const LevelBoxes& level) const
{
  std::vector<Piece> pieces;
  for (const IndexBox& box : level.boxes) cut(0, box, level, pieces);
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Piece& a, const Piece& b) { return a.region < b.region; });
  return pieces;
}

void RecursiveBisection::cut(int node, const IndexBox& box, const LevelBoxes& level,
                             std::vector<Piece>& pieces) const
{
  if (box.empty()) return;
  const Node& n = nodes_[static_cast<std::size_t>(node)];
  if (n.low < 0) {
    pieces.push_back({box, n.first});
    return;
  }
  const auto d = static_cast<std::size_t>(n.d);
  const int at = level.block * static_cast<int>(std::lround(n.x / (level.block * level.h)));
  IndexBox low = box, high = box;
  low.hi[d] = std::min(low.hi[d], at);
  high.lo[d] = std::max(high.lo[d], at);
  cut(n.low, low, level, pieces);
  cut(n.high, high, level, pieces);
}

}  // namespace valsalva::ib3d
