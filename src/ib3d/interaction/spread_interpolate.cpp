#include "ib3d/interaction/spread_interpolate.hpp"

#include "ib3d/grid/mirror.hpp"
#include "ib3d/interaction/delta.hpp"

namespace valsalva::ib3d {

namespace {

/// Four neighbouring doubles, anywhere in memory.
using Four = double __attribute__((vector_size(32)));
using FourInMemory = double __attribute__((vector_size(32), aligned(8), may_alias));

/// Indices and weights of one node on the two lattices of each direction: [d][0] faces, [d][1] cell centres.
struct Support {
  int start[3][2];
  double weight[3][2][kDeltaWidth];
};

inline Support support_of(const Vec3& X, double inverse_h)
{
  Support s;
  for (int d = 0; d < 3; ++d)
    for (int lattice = 0; lattice < 2; ++lattice) {
      const double at = X[d] * inverse_h - 0.5 * lattice;
      const double below = std::floor(at);
      s.start[d][lattice] = static_cast<int>(below) - 1;
      delta_weights(at - below, s.weight[d][lattice]);
    }
  return s;
}

/// The lattice of direction d for component c.
constexpr int lattice_of(int c, int d)
{
  return c == d ? 0 : 1;
}

}  // namespace

void Interaction::spread(std::span<const int> first, std::span<const Vec3> X, std::span<const Vec3> F,
                         MacField& f) const
{
  const double inverse_h = 1 / level_.h, inverse_volume = inverse_h * inverse_h * inverse_h;
  f.set_zero();
  for (int p = 0; p < level_.local_count(); ++p) {
    const std::ptrdiff_t sy = f(p, 0).stride(1), sz = f(p, 0).stride(2);
    for (int n = first[static_cast<std::size_t>(p)]; n < first[static_cast<std::size_t>(p) + 1]; ++n) {
      const auto node = static_cast<std::size_t>(n);
      const Support s = support_of(X[node], inverse_h);
      for (int c = 0; c < 3; ++c) {
        const int lx = lattice_of(c, 0), ly = lattice_of(c, 1), lz = lattice_of(c, 2);
        double* corner = f(p, c).at(s.start[0][lx], s.start[1][ly], s.start[2][lz]);
        Four x;
        for (int m = 0; m < kDeltaWidth; ++m) x[m] = s.weight[0][lx][m] * F[node][c] * inverse_volume;
        for (int k = 0; k < kDeltaWidth; ++k)
          for (int j = 0; j < kDeltaWidth; ++j) {
            auto* row = reinterpret_cast<FourInMemory*>(corner + j * sy + k * sz);
            *row = *row + (s.weight[1][ly][j] * s.weight[2][lz][k]) * x;
          }
      }
    }
  }
  fold_mirrored(level_, f);
  faces_.accumulate(f);
}

void Interaction::interpolate(std::span<const int> first, std::span<const Vec3> X, const MacField& u,
                              std::span<Vec3> U) const
{
  const double inverse_h = 1 / level_.h;
  for (int p = 0; p < level_.local_count(); ++p) {
    const std::ptrdiff_t sy = u(p, 0).stride(1), sz = u(p, 0).stride(2);
    for (int n = first[static_cast<std::size_t>(p)]; n < first[static_cast<std::size_t>(p) + 1]; ++n) {
      const auto node = static_cast<std::size_t>(n);
      const Support s = support_of(X[node], inverse_h);
      for (int c = 0; c < 3; ++c) {
        const int lx = lattice_of(c, 0), ly = lattice_of(c, 1), lz = lattice_of(c, 2);
        const double* corner = u(p, c).at(s.start[0][lx], s.start[1][ly], s.start[2][lz]);
        Four sum{};
        for (int k = 0; k < kDeltaWidth; ++k) {
          Four plane{};
          for (int j = 0; j < kDeltaWidth; ++j)
            plane += s.weight[1][ly][j] * *reinterpret_cast<const FourInMemory*>(corner + j * sy + k * sz);
          sum += s.weight[2][lz][k] * plane;
        }
        double value = 0;
        for (int m = 0; m < kDeltaWidth; ++m) value += s.weight[0][lx][m] * sum[m];
        U[node][c] = value;
      }
    }
  }
}

void Interaction::fill_ghosts(MacField& u) const
{
  faces_.fill(u);
  fill_mirrored(level_, u);
}

}  // namespace valsalva::ib3d
