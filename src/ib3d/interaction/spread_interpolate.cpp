#include "ib3d/interaction/spread_interpolate.hpp"

#include <limits>

#include "ib3d/interaction/delta.hpp"

namespace valsalva::ib3d {

namespace {

// Without AVX (the asan preset) GCC notes that such a value is passed otherwise; here none leaves the file.
#pragma GCC diagnostic ignored "-Wpsabi"

/// Four neighbouring doubles, anywhere in memory.
using Four = double __attribute__((vector_size(32)));
using FourInMemory = double __attribute__((vector_size(32), aligned(8), may_alias));

inline Four four(const double (&c)[kDeltaWidth])
{
  return Four{c[0], c[1], c[2], c[3]};
}

/// Lattices that carry the components: faces along x, y, z, then cell centres along x, y, z.
constexpr int kLattices = 6;
/// Nodes whose supports are found together, side by side in vector registers.
constexpr int kBlock = 32;

struct Supports {
  int start[kLattices][kBlock];  ///< lowest of the four lattice points
  double r[kLattices][kBlock], root[kLattices][kBlock];
};

inline void find_supports(const Vec3* X, int count, double inverse_h, Supports& s)
{
  for (int l = 0; l < kLattices; ++l)
    for (int m = 0; m < count; ++m) {
      const double at = X[m][l % 3] * inverse_h - (l < 3 ? 0.0 : 0.5);
      const double below = std::floor(at), r = at - below;
      s.start[l][m] = static_cast<int>(below) - 1;
      s.r[l][m] = r;
      s.root[l][m] = delta_root(r);
    }
}

/// The lattice of direction d for component c.
constexpr int lattice_of(int c, int d)
{
  return c == d ? d : 3 + d;
}

/// Where one node acts: its lowest lattice points and the weights of all four.
struct Support {
  int start[kLattices];
  Four weight[kLattices];
  Support(const Supports& s, int m)
  {
    for (int l = 0; l < kLattices; ++l) {
      start[l] = s.start[l][m];
      weight[l] = four(kDeltaBase) + s.r[l][m] * four(kDeltaSlope) + s.root[l][m] * four(kDeltaRoot);
    }
  }
  const Four& of(int c, int d) const { return weight[lattice_of(c, d)]; }
};

template <class T>
inline T* corner_of(const Support& s, int c, T* origin, const IndexBox& stored, std::ptrdiff_t sy,
                    std::ptrdiff_t sz)
{
  return origin + (s.start[lattice_of(c, 0)] - stored.lo[0]) +
         (s.start[lattice_of(c, 1)] - stored.lo[1]) * sy + (s.start[lattice_of(c, 2)] - stored.lo[2]) * sz;
}

/// Adds force times the weights of component c; the innermost four points lie along x.
inline void add_to_rows(double* corner, std::ptrdiff_t sy, std::ptrdiff_t sz, const Support& s, int c,
                        double force)
{
  const Four x = force * s.of(c, 0), y = s.of(c, 1), z = s.of(c, 2);
  for (int k = 0; k < kDeltaWidth; ++k, corner += sz) {
    const Four zx = z[k] * x;
    for (int j = 0; j < kDeltaWidth; ++j) {
      auto* row = reinterpret_cast<FourInMemory*>(corner + j * sy);
      *row = *row + y[j] * zx;
    }
  }
}

inline double sum_of_rows(const double* corner, std::ptrdiff_t sy, std::ptrdiff_t sz, const Support& s, int c)
{
  const Four x = s.of(c, 0), y = s.of(c, 1), z = s.of(c, 2);
  Four sum{};
  for (int k = 0; k < kDeltaWidth; ++k, corner += sz) {
    const auto row = [&](int j) { return *reinterpret_cast<const FourInMemory*>(corner + j * sy); };
    sum += z[k] * (y[0] * row(0) + y[1] * row(1) + y[2] * row(2) + y[3] * row(3));
  }
  sum *= x;
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

/// The support of component c with the points outside the domain mirrored about its sides.
struct MirroredSupport {
  int index[3][kDeltaWidth];
  bool whole_rows;  ///< no point is mirrored along x

  MirroredSupport(const Support& s, int c, const Level& level)
  {
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
    whole_rows = index[0][kDeltaWidth - 1] - index[0][0] == kDeltaWidth - 1;
  }

  /// Calls row(first point, weight along y and z) for the 16 rows of a.
  template <class Field, class Row>
  void for_each_row(const Support& s, int c, Field& a, Row&& row) const
  {
    const Four &y = s.of(c, 1), &z = s.of(c, 2);
    for (int k = 0; k < kDeltaWidth; ++k)
      for (int j = 0; j < kDeltaWidth; ++j) row(a.at(index[0][0], index[1][j], index[2][k]), z[k] * y[j]);
  }
  int step(int m) const { return index[0][m] - index[0][0]; }
};

// Nodes beside a side are few: kept out of line, so that the loops over the others stay tight.
[[gnu::noinline]] void spread_mirrored(const Support& s, const Level& level, const Vec3& density, MacField& f,
                                       int patch)
{
  for (int c = 0; c < 3; ++c) {
    const MirroredSupport at(s, c, level);
    const Four x = density[c] * s.of(c, 0);
    at.for_each_row(s, c, f(patch, c), [&](double* row, double yz) {
      if (at.whole_rows) {
        auto* four = reinterpret_cast<FourInMemory*>(row);
        *four = *four + yz * x;
      } else {
        for (int m = 0; m < kDeltaWidth; ++m) row[at.step(m)] += yz * x[m];
      }
    });
  }
}

[[gnu::noinline]] Vec3 interpolate_mirrored(const Support& s, const Level& level, const MacField& u,
                                            int patch)
{
  Vec3 value{0, 0, 0};
  for (int c = 0; c < 3; ++c) {
    const MirroredSupport at(s, c, level);
    Four sum{};
    at.for_each_row(s, c, u(patch, c), [&](const double* row, double yz) {
      if (at.whole_rows) {
        sum += yz * *reinterpret_cast<const FourInMemory*>(row);
      } else {
        for (int m = 0; m < kDeltaWidth; ++m) sum[m] += yz * row[at.step(m)];
      }
    });
    sum *= s.of(c, 0);
    value[c] = (sum[0] + sum[1]) + (sum[2] + sum[3]);
  }
  return value;
}

/// Calls act(node, support) for the nodes first <= n < last.
template <class Act>
inline void for_each_support(int first, int last, std::span<const Vec3> X, double inverse_h, Act&& act)
{
  Supports block;
  for (int n = first; n < last; n += kBlock) {
    const int count = std::min(kBlock, last - n);
    find_supports(X.data() + n, count, inverse_h, block);
    for (int m = 0; m < count; ++m) act(static_cast<std::size_t>(n + m), Support(block, m));
  }
}

}  // namespace

void Interaction::spread(std::span<const int> first, std::span<const Vec3> X, std::span<const Vec3> F,
                         MacField& f) const
{
  const double inverse_h = 1 / level_->h, inverse_volume = inverse_h * inverse_h * inverse_h;
  const Inside inside(*level_);
  f.set_zero();
  for (int p = 0; p < level_->local_count(); ++p) {
    const IndexBox stored = f(p, 0).stored();
    const std::ptrdiff_t sy = f(p, 0).stride(1), sz = f(p, 0).stride(2);
    double* const origin[3] = {f(p, 0).data().data(), f(p, 1).data().data(), f(p, 2).data().data()};
    const auto q = static_cast<std::size_t>(p);
    for_each_support(first[q], first[q + 1], X, inverse_h, [&](std::size_t node, const Support& s) {
      if (!inside.holds(X[node])) {
        spread_mirrored(s, *level_, inverse_volume * F[node], f, p);
        return;
      }
      for (int c = 0; c < 3; ++c)
        add_to_rows(corner_of(s, c, origin[c], stored, sy, sz), sy, sz, s, c, F[node][c] * inverse_volume);
    });
  }
  faces_.accumulate(f);
}

void interpolate(const Level& level, std::span<const int> first, std::span<const Vec3> X, const MacField& u,
                 std::span<Vec3> U)
{
  const double inverse_h = 1 / level.h;
  const Inside inside(level);
  for (int p = 0; p < level.local_count(); ++p) {
    const IndexBox stored = u(p, 0).stored();
    const std::ptrdiff_t sy = u(p, 0).stride(1), sz = u(p, 0).stride(2);
    const double* const origin[3] = {u(p, 0).data().data(), u(p, 1).data().data(), u(p, 2).data().data()};
    const auto q = static_cast<std::size_t>(p);
    for_each_support(first[q], first[q + 1], X, inverse_h, [&](std::size_t node, const Support& s) {
      if (!inside.holds(X[node])) {
        U[node] = interpolate_mirrored(s, level, u, p);
        return;
      }
      for (int c = 0; c < 3; ++c)
        U[node][c] = sum_of_rows(corner_of(s, c, origin[c], stored, sy, sz), sy, sz, s, c);
    });
  }
}

}  // namespace valsalva::ib3d
