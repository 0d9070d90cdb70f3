#include "ib3d/interaction/spread_interpolate.hpp"

#include <limits>

#include "ib3d/grid/mirror.hpp"
#include "ib3d/interaction/delta.hpp"

namespace valsalva::ib3d {

namespace {

/// Four neighbouring doubles, anywhere in memory.
using Four = double __attribute__((vector_size(32)));
using FourInMemory = double __attribute__((vector_size(32), aligned(8), may_alias));

inline Four four(const double (&c)[kDeltaWidth])
{
  return Four{c[0], c[1], c[2], c[3]};
}

/// Lattices of one node: faces along x, y, z, then cell centres along x, y, z; two lanes of padding.
constexpr int kLattices = 6, kLanes = 8;

struct Support {
  int start[kLanes];       ///< lowest of the four lattice points
  Four weight[kLattices];  ///< of the four points
};

inline void find_support(const Vec3& X, double inverse_h, Support& s)
{
  const double at[kLanes] = {X[0] * inverse_h,
                             X[1] * inverse_h,
                             X[2] * inverse_h,
                             X[0] * inverse_h - 0.5,
                             X[1] * inverse_h - 0.5,
                             X[2] * inverse_h - 0.5,
                             0.0,
                             0.0};
  double r[kLanes], root[kLanes];
  for (int l = 0; l < kLanes; ++l) {
    const double below = std::floor(at[l]);
    s.start[l] = static_cast<int>(below) - 1;
    r[l] = at[l] - below;
    root[l] = delta_root(r[l]);
  }
  for (int l = 0; l < kLattices; ++l)
    s.weight[l] = four(kDeltaBase) + r[l] * four(kDeltaSlope) + root[l] * four(kDeltaRoot);
}

/// The lattice of direction d for component c.
constexpr int lattice_of(int c, int d)
{
  return c == d ? d : 3 + d;
}

/// Weights of component c along x, and the products of those along y and z, row j + 4 k.
struct RowWeights {
  Four x;
  double yz[kDeltaWidth * kDeltaWidth];
};

inline RowWeights row_weights(const Support& s, int c)
{
  RowWeights w;
  w.x = s.weight[lattice_of(c, 0)];
  const Four y = s.weight[lattice_of(c, 1)], z = s.weight[lattice_of(c, 2)];
  for (int k = 0; k < kDeltaWidth; ++k) *reinterpret_cast<FourInMemory*>(w.yz + kDeltaWidth * k) = z[k] * y;
  return w;
}

template <class T>
inline T* corner_of(const Support& s, int c, T* origin, const IndexBox& stored, std::ptrdiff_t sy,
                    std::ptrdiff_t sz)
{
  return origin + (s.start[lattice_of(c, 0)] - stored.lo[0]) +
         (s.start[lattice_of(c, 1)] - stored.lo[1]) * sy + (s.start[lattice_of(c, 2)] - stored.lo[2]) * sz;
}

inline void add_to_rows(double* corner, std::ptrdiff_t sy, std::ptrdiff_t sz, const RowWeights& w,
                        double force)
{
  const Four x = force * w.x;
  for (int k = 0; k < kDeltaWidth; ++k, corner += sz) {
    double* row = corner;
    for (int j = 0; j < kDeltaWidth; ++j, row += sy) {
      auto* four = reinterpret_cast<FourInMemory*>(row);
      *four = *four + w.yz[kDeltaWidth * k + j] * x;
    }
  }
}

inline double sum_of_rows(const double* corner, std::ptrdiff_t sy, std::ptrdiff_t sz, const RowWeights& w)
{
  Four even{}, odd{};
  for (int k = 0; k < kDeltaWidth; ++k, corner += sz) {
    const auto row = [&](int j) { return *reinterpret_cast<const FourInMemory*>(corner + j * sy); };
    even += w.yz[kDeltaWidth * k] * row(0);
    odd += w.yz[kDeltaWidth * k + 1] * row(1);
    even += w.yz[kDeltaWidth * k + 2] * row(2);
    odd += w.yz[kDeltaWidth * k + 3] * row(3);
  }
  const Four sum = (even + odd) * w.x;
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

/// The range of nodes whose support lies inside the domain in every direction (cm).
struct Inside {
  double lo[3], hi[3];
  explicit Inside(const Level& level)
  {
    for (int d = 0; d < 3; ++d) {
      const double far = level.domain.periodic(d) ? std::numeric_limits<double>::infinity() : 0.0;
      lo[d] = (level.box.lo[static_cast<std::size_t>(d)] + 1.5) * level.h - far;
      hi[d] = (level.box.hi[static_cast<std::size_t>(d)] - 1.5) * level.h + far;
    }
  }
  bool holds(const Vec3& X) const
  {
    return static_cast<int>(X[0] >= lo[0]) & static_cast<int>(X[0] < hi[0]) &
           static_cast<int>(X[1] >= lo[1]) & static_cast<int>(X[1] < hi[1]) &
           static_cast<int>(X[2] >= lo[2]) & static_cast<int>(X[2] < hi[2]);
  }
};

/// Calls point(i, j, k, weight) for the 64 points of component c, those outside the domain mirrored about its sides.
template <class Point>
void for_each_mirrored_point(const Support& s, int c, const Level& level, Point&& point)
{
  int index[3][kDeltaWidth];
  for (int d = 0; d < 3; ++d) {
    const auto dd = static_cast<std::size_t>(d);
    const int centred =
        c == d ? 0 : 1;  // the mirror image of a face is 2 L - i, of a cell centre 2 L - 1 - i
    for (int m = 0; m < kDeltaWidth; ++m) {
      int i = s.start[lattice_of(c, d)] + m;
      if (!level.domain.periodic(d)) {
        if (i < level.box.lo[dd]) i = 2 * level.box.lo[dd] - centred - i;
        if (i > level.box.hi[dd] - centred) i = 2 * level.box.hi[dd] - centred - i;
      }
      index[d][m] = i;
    }
  }
  const Four &x = s.weight[lattice_of(c, 0)], &y = s.weight[lattice_of(c, 1)],
             &z = s.weight[lattice_of(c, 2)];
  for (int k = 0; k < kDeltaWidth; ++k)
    for (int j = 0; j < kDeltaWidth; ++j)
      for (int i = 0; i < kDeltaWidth; ++i) point(index[0][i], index[1][j], index[2][k], x[i] * y[j] * z[k]);
}

// Nodes beside a side are few: kept out of line, so that the loops over the others stay tight.
[[gnu::noinline]] void spread_mirrored(const Support& s, const Level& level, const Vec3& density, MacField& f,
                                       int patch)
{
  for (int c = 0; c < 3; ++c)
    for_each_mirrored_point(s, c, level, [&](int i, int j, int k, double weight) {
      f(patch, c)(i, j, k) += weight * density[c];
    });
}

[[gnu::noinline]] Vec3 interpolate_mirrored(const Support& s, const Level& level, const MacField& u,
                                            int patch)
{
  Vec3 sum{0, 0, 0};
  for (int c = 0; c < 3; ++c)
    for_each_mirrored_point(
        s, c, level, [&](int i, int j, int k, double weight) { sum[c] += weight * u(patch, c)(i, j, k); });
  return sum;
}

}  // namespace

void Interaction::spread(std::span<const int> first, std::span<const Vec3> X, std::span<const Vec3> F,
                         MacField& f) const
{
  const double inverse_h = 1 / level_.h, inverse_volume = inverse_h * inverse_h * inverse_h;
  const Inside inside(level_);
  f.set_zero();
  for (int p = 0; p < level_.local_count(); ++p) {
    const IndexBox stored = f(p, 0).stored();
    const std::ptrdiff_t sy = f(p, 0).stride(1), sz = f(p, 0).stride(2);
    double* const origin[3] = {f(p, 0).data().data(), f(p, 1).data().data(), f(p, 2).data().data()};
    for (int n = first[static_cast<std::size_t>(p)]; n < first[static_cast<std::size_t>(p) + 1]; ++n) {
      const auto node = static_cast<std::size_t>(n);
      Support s;
      find_support(X[node], inverse_h, s);
      if (!inside.holds(X[node])) {
        spread_mirrored(s, level_, inverse_volume * F[node], f, p);
        continue;
      }
      for (int c = 0; c < 3; ++c)
        add_to_rows(corner_of(s, c, origin[c], stored, sy, sz), sy, sz, row_weights(s, c),
                    F[node][c] * inverse_volume);
    }
  }
  faces_.accumulate(f);
}

void Interaction::interpolate(std::span<const int> first, std::span<const Vec3> X, const MacField& u,
                              std::span<Vec3> U) const
{
  const double inverse_h = 1 / level_.h;
  const Inside inside(level_);
  for (int p = 0; p < level_.local_count(); ++p) {
    const IndexBox stored = u(p, 0).stored();
    const std::ptrdiff_t sy = u(p, 0).stride(1), sz = u(p, 0).stride(2);
    const double* const origin[3] = {u(p, 0).data().data(), u(p, 1).data().data(), u(p, 2).data().data()};
    for (int n = first[static_cast<std::size_t>(p)]; n < first[static_cast<std::size_t>(p) + 1]; ++n) {
      const auto node = static_cast<std::size_t>(n);
      Support s;
      find_support(X[node], inverse_h, s);
      if (!inside.holds(X[node])) {
        U[node] = interpolate_mirrored(s, level_, u, p);
        continue;
      }
      for (int c = 0; c < 3; ++c)
        U[node][c] = sum_of_rows(corner_of(s, c, origin[c], stored, sy, sz), sy, sz, row_weights(s, c));
    }
  }
}

void Interaction::fill_ghosts(MacField& u) const
{
  faces_.fill(u);
  fill_mirrored(level_, u);
}

}  // namespace valsalva::ib3d
