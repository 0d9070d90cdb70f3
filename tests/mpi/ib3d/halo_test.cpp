// Exchange of ghosts between boxes and ranks: every ghost gets its owner's value, and `accumulate` is the exact
// transpose of `fill`. On any number of ranks and boxes.
#include "ib3d/grid/halo.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "ib3d/fluid/tube.hpp"

namespace valsalva::ib3d {
namespace {

double sum_over_ranks(double x)
{
  MPI_Allreduce(MPI_IN_PLACE, &x, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return x;
}

/// A rough number in [-1/2, 1/2), the same wherever it is computed: integers only, so that no rounding differs.
double noise(int i, int j, int k, int seed)
{
  std::uint32_t x = static_cast<std::uint32_t>(i) * 73856093U ^ static_cast<std::uint32_t>(j) * 19349663U ^
                    static_cast<std::uint32_t>(k) * 83492791U ^
                    static_cast<std::uint32_t>(seed) * 2654435761U;
  for (const std::uint32_t factor : {2246822519U, 3266489917U}) x = (x ^ (x >> 15)) * factor;
  return static_cast<double>(x >> 8) / 16777216.0 - 0.5;
}

/// Indices of the whole stored array of a patch, with seed different for every patch.
void fill_all_at_random(const Level& level, MacField& u, int seed)
{
  for (int p = 0; p < level.local_count(); ++p)
    for (int c = 0; c < 3; ++c)
      for_each_index(u(p, c).stored(), [&](int i, int j, int k) {
        u(p, c)(i, j, k) = noise(i, j, k, seed + c + 10 * level.local[static_cast<std::size_t>(p)]);
      });
}

/// Faces of a patch that `fill` may write or `accumulate` may read: its box with ghosts.
IndexBox ghosted(const Level& level, int p, int c)
{
  return faces_of(level.local_box(p).grown(kMacGhosts), c);
}

double product(const Level& level, const MacField& a, const MacField& b, bool owned_only)
{
  double sum = 0;
  for (int p = 0; p < level.local_count(); ++p)
    for (int c = 0; c < 3; ++c) {
      const auto add = [&](int i, int j, int k) { sum += a(p, c)(i, j, k) * b(p, c)(i, j, k); };
      if (owned_only)
        for_each_owned_face(level, p, c, add);
      else
        for_each_index(ghosted(level, p, c), add);
    }
  return sum_over_ranks(sum);
}

struct Layout {
  Domain domain;
  int boxes;
};

std::vector<Layout> layouts()
{
  Domain mixed = walled_box({2, 2, 4});
  mixed.sides[2] = mixed.sides[3] = SideKind::periodic;
  return {{walled_box({2, 2, 4}), 0},
          {walled_box({2, 2, 4}), 7},
          {periodic_box({2, 2, 4}), 0},
          {periodic_box({2, 2, 4}), 6},
          {mixed, 5},
          {periodic_box({1, 1, 4}), 4}};
}

TEST(Halo, EveryGhostGetsTheValueOfItsOwner)
{
  for (const Layout& layout : layouts()) {
    const Hierarchy grid(layout.domain, 0.125, MPI_COMM_WORLD, layout.boxes);
    const Level& level = grid.finest();
    const auto at = [&](int index, int d, bool& inside) {
      const auto dd = static_cast<std::size_t>(d);
      const int n = level.box.size(d);
      if (layout.domain.periodic(d)) return ((index % n) + n) % n;
      inside = inside && index >= level.box.lo[dd] && index <= level.box.hi[dd];
      return index;
    };
    const auto value = [&](int i, int j, int k, int c, bool& inside) {
      const std::array<int, 3> x{at(i, 0, inside), at(j, 1, inside), at(k, 2, inside)};
      for (int d = 0; d < 3; ++d)  // a side that is no boundary of this component ends one index earlier
        if (d != c && !layout.domain.periodic(d) && x[static_cast<std::size_t>(d)] == level.box.size(d))
          inside = false;
      return noise(x[0], x[1], x[2], c);
    };
    MacField u(level);
    for (int p = 0; p < level.local_count(); ++p)
      for (int c = 0; c < 3; ++c) {
        for_each_index(u(p, c).stored(), [&](int i, int j, int k) { u(p, c)(i, j, k) = 1e30; });
        for_each_owned_face(level, p, c, [&](int i, int j, int k) {
          bool inside = true;
          u(p, c)(i, j, k) = value(i, j, k, c, inside);
        });
      }
    Halo::for_faces(level).fill(u);
    double wrong = 0, checked = 0;
    for (int p = 0; p < level.local_count(); ++p)
      for (int c = 0; c < 3; ++c)
        for_each_index(ghosted(level, p, c), [&](int i, int j, int k) {
          bool inside = true;
          const double expected = value(i, j, k, c, inside);
          if (!inside) return;
          checked += 1;
          wrong += u(p, c)(i, j, k) == expected ? 0 : 1;
        });
    EXPECT_EQ(sum_over_ranks(wrong), 0) << layout.boxes << " boxes";
    EXPECT_GT(sum_over_ranks(checked), 3.0 * static_cast<double>(level.box.volume()));
  }
}

TEST(Halo, AccumulateIsTheTransposeOfFill)
{
  for (const Layout& layout : layouts()) {
    const Hierarchy grid(layout.domain, 0.125, MPI_COMM_WORLD, layout.boxes);
    const Level& level = grid.finest();
    const Halo halo = Halo::for_faces(level);
    MacField u(level), f(level);
    fill_all_at_random(level, u, 3);
    fill_all_at_random(level, f, 1000);
    // Ghosts beyond walls belong to nobody: take them out of the product on both sides.
    MacField filled = u;
    for (int p = 0; p < level.local_count(); ++p)
      for (int c = 0; c < 3; ++c) {
        filled(p, c).set_zero();
        for_each_owned_face(level, p, c,
                            [&](int i, int j, int k) { filled(p, c)(i, j, k) = u(p, c)(i, j, k); });
      }
    halo.fill(filled);
    const double everywhere = product(level, filled, f, false);
    halo.accumulate(f);
    const double at_owners = product(level, u, f, true);
    EXPECT_GT(std::abs(everywhere), 0.01);
    EXPECT_NEAR(at_owners, everywhere, 1e-9) << layout.boxes << " boxes";
  }
}

TEST(Halo, CellGhostsArriveInSinglePrecisionToo)
{
  const Hierarchy grid(periodic_box({2, 2, 4}), 0.125, MPI_COMM_WORLD, 6);
  const Level& level = grid.finest();
  CellField<float> a(level);
  const auto value = [&](int i, int j, int k) {
    const auto wrapped = [&](int x, int d) { return (x + level.box.size(d)) % level.box.size(d); };
    return static_cast<float>(noise(wrapped(i, 0), wrapped(j, 1), wrapped(k, 2), 5));
  };
  for (int p = 0; p < level.local_count(); ++p)
    for_each_index(level.local_box(p), [&](int i, int j, int k) { a[p](i, j, k) = value(i, j, k); });
  Halo::for_cells(level, 1).fill(a);
  double wrong = 0;
  for (int p = 0; p < level.local_count(); ++p)
    for_each_index(level.local_box(p).grown(1),
                   [&](int i, int j, int k) { wrong += a[p](i, j, k) == value(i, j, k) ? 0 : 1; });
  EXPECT_EQ(sum_over_ranks(wrong), 0);
}

}  // namespace
}  // namespace valsalva::ib3d
