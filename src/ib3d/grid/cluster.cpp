#include "ib3d/grid/cluster.hpp"

#include <algorithm>
#include <cstdlib>

namespace valsalva::ib3d {

Tiles::Tiles(const IndexBox& cells)
    : box_{{0, 0, 0},
           {cells.hi[0] / kBlockingFactor, cells.hi[1] / kBlockingFactor, cells.hi[2] / kBlockingFactor}},
      tag_(static_cast<std::size_t>(box_.volume()), 0)
{
}

void Tiles::add(const IndexBox& cells, const Domain& domain)
{
  IndexBox tiles;
  for (int d = 0; d < 3; ++d) {
    const auto dd = static_cast<std::size_t>(d);
    const auto tile = [](int c) {
      return (c - (((c % kBlockingFactor) + kBlockingFactor) % kBlockingFactor)) / kBlockingFactor;
    };
    tiles.lo[dd] = tile(cells.lo[dd]);
    tiles.hi[dd] = tile(cells.hi[dd] - 1) + 1;
    if (domain.periodic(d)) continue;
    tiles.lo[dd] = std::max(tiles.lo[dd], 0);
    tiles.hi[dd] = std::min(tiles.hi[dd], box_.hi[dd]);
  }
  const auto wrapped = [&](int i, std::size_t d) { return ((i % box_.hi[d]) + box_.hi[d]) % box_.hi[d]; };
  for_each_index(tiles, [&](int i, int j, int k) { set(wrapped(i, 0), wrapped(j, 1), wrapped(k, 2)); });
}

void Tiles::fill_enclosed()
{
  for (int k = 0; k < box_.hi[2]; ++k) {
    IndexBox layer = box_;
    layer.lo[2] = k;
    layer.hi[2] = k + 1;
    std::vector<std::uint8_t> outside(static_cast<std::size_t>(layer.volume()), 0);
    const auto at = [&](int i, int j) { return static_cast<std::size_t>(i + box_.hi[0] * j); };
    std::vector<Int3> front;
    const auto reach = [&](int i, int j) {
      if (i < 0 || j < 0 || i >= box_.hi[0] || j >= box_.hi[1] || outside[at(i, j)] != 0 || (*this)(i, j, k))
        return;
      outside[at(i, j)] = 1;
      front.push_back({i, j, k});
    };
    for_each_index(layer, [&](int i, int j, int) {
      if (i == 0 || j == 0 || i + 1 == box_.hi[0] || j + 1 == box_.hi[1]) reach(i, j);
    });
    while (!front.empty()) {
      const Int3 c = front.back();
      front.pop_back();
      reach(c[0] - 1, c[1]);
      reach(c[0] + 1, c[1]);
      reach(c[0], c[1] - 1);
      reach(c[0], c[1] + 1);
    }
    for_each_index(layer, [&](int i, int j, int) {
      if (outside[at(i, j)] == 0) set(i, j, k);
    });
  }
}

namespace {

/// Tagged tiles in every plane of a box across direction d.
std::vector<int> signature(const Tiles& tags, const IndexBox& box, int d)
{
  std::vector<int> sum(static_cast<std::size_t>(box.size(d)), 0);
  for_each_index(box, [&](int i, int j, int k) {
    const Int3 at{i, j, k};
    const auto dd = static_cast<std::size_t>(d);
    if (tags(i, j, k)) ++sum[static_cast<std::size_t>(at[dd] - box.lo[dd])];
  });
  return sum;
}

/// The box around the tags in a box, and their number.
IndexBox shrunk(const Tiles& tags, IndexBox box, int& count)
{
  count = 0;
  for (int d = 0; d < 3; ++d) {
    const auto dd = static_cast<std::size_t>(d);
    const std::vector<int> sum = signature(tags, box, d);
    const auto tagged = [](int s) { return s > 0; };
    const auto first = std::find_if(sum.begin(), sum.end(), tagged);
    if (first == sum.end()) return {};
    const auto last = std::find_if(sum.rbegin(), sum.rend(), tagged);
    box.hi[dd] = box.lo[dd] + static_cast<int>(sum.rend() - last);
    box.lo[dd] += static_cast<int>(first - sum.begin());
    count = 0;
    for (int s : sum) count += s;
  }
  return box;
}

/// Where to cut a box: direction (-1: nowhere) and first index of the upper part.
struct Cut {
  int d = -1, at = 0;
};

Cut best_cut(const Tiles& tags, const IndexBox& box)
{
  Cut cut;
  int steepest = -1;
  for (int d = 0; d < 3; ++d) {
    const std::vector<int> s = signature(tags, box, d);
    const int lo = box.lo[static_cast<std::size_t>(d)], n = static_cast<int>(s.size());
    for (int i = 1; i + 1 < n; ++i)
      if (s[static_cast<std::size_t>(i)] == 0) return {d, lo + i};
    for (int i = 1; i < n; ++i) {
      const int jump = std::abs(s[static_cast<std::size_t>(i)] - s[static_cast<std::size_t>(i) - 1]);
      if (jump > steepest) {
        steepest = jump;
        cut = {d, lo + i};
      }
    }
  }
  return cut;
}

void split(const Tiles& tags, const IndexBox& part, double efficiency, std::vector<IndexBox>& boxes)
{
  int count = 0;
  const IndexBox box = shrunk(tags, part, count);
  if (box.empty()) return;
  const Cut cut = best_cut(tags, box);
  if (static_cast<double>(count) >= efficiency * static_cast<double>(box.volume()) || cut.d < 0) {
    boxes.push_back(box);
    return;
  }
  const auto d = static_cast<std::size_t>(cut.d);
  IndexBox low = box, high = box;
  low.hi[d] = high.lo[d] = cut.at;
  split(tags, low, efficiency, boxes);
  split(tags, high, efficiency, boxes);
}

/// Joins two boxes whose union is a box; whether there were any.
bool merge_two(std::vector<IndexBox>& boxes)
{
  for (std::size_t a = 0; a < boxes.size(); ++a)
    for (std::size_t b = a + 1; b < boxes.size(); ++b) {
      IndexBox both;
      for (std::size_t d = 0; d < 3; ++d) {
        both.lo[d] = std::min(boxes[a].lo[d], boxes[b].lo[d]);
        both.hi[d] = std::max(boxes[a].hi[d], boxes[b].hi[d]);
      }
      if (both.volume() != boxes[a].volume() + boxes[b].volume()) continue;
      boxes[a] = both;
      boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(b));
      return true;
    }
  return false;
}

}  // namespace

std::vector<IndexBox> cluster(const Tiles& tags, double efficiency)
{
  std::vector<IndexBox> boxes;
  split(tags, tags.box(), efficiency, boxes);
  while (merge_two(boxes)) {
  }
  for (IndexBox& b : boxes)
    for (std::size_t d = 0; d < 3; ++d) {
      b.lo[d] *= kBlockingFactor;
      b.hi[d] *= kBlockingFactor;
    }
  return boxes;
}

}  // namespace valsalva::ib3d
