#include "ib3d/structure/aortic_root/leaflet_equilibrium.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "common/units.hpp"
#include "ib3d/structure/aortic_root/root_shape.hpp"
#include "ib3d/structure/fibres/fibre_force.hpp"
#include "ib3d/structure/fibres/fibre_strain.hpp"

namespace valsalva::ib3d {

namespace {

constexpr double kGap = 0.025;    // cm between a leaflet and its neighbour's plane
constexpr double kContact = 5e7;  // dyn/cm^3
constexpr int kMaxIterations = 60000;
constexpr double kSqrt3Half = 0.86602540378443865;
constexpr Vec3 kPlaneNormal[2] = {{kSqrt3Half, 0.5, 0.0}, {kSqrt3Half, -0.5, 0.0}};  // into the leaflet
constexpr std::int8_t kNeighbour[2] = {-1, 1};  // previous (theta = -60 degrees), next

std::size_t at(int node)
{
  return static_cast<std::size_t>(node);
}

Vec3 area_vector(const std::array<int, 3>& t, std::span<const Vec3> X)
{
  return 0.5 * cross(X[at(t[1])] - X[at(t[0])], X[at(t[2])] - X[at(t[0])]);
}

std::vector<double> reference_areas(const LeafletLattice& lattice)
{
  std::vector<double> area(lattice.s.size(), 0.0);
  for (const std::array<int, 3>& t : lattice.triangles) {
    const double third = norm(area_vector(t, lattice.network.X)) / 3.0;
    for (int node : t) area[at(node)] += third;
  }
  return area;
}

/// The gap a node keeps: nodes that are near a plane already on the tube (beside a commissure) keep less.
double gap_of(const LeafletLattice& lattice, std::size_t node, const Vec3& normal)
{
  return std::min(kGap, 0.5 * dot(normal, lattice.network.X[node]));
}

void add_contact(const LeafletLattice& lattice, const std::vector<double>& area, std::span<const Vec3> X,
                 std::span<Vec3> F)
{
  for (std::size_t i = 0; i < X.size(); ++i) {
    if (lattice.on_edge[i] != 0) continue;
    for (std::size_t side = 0; side < 2; ++side) {
      const Vec3& normal = kPlaneNormal[side];
      const double depth = gap_of(lattice, i, normal) - dot(normal, X[i]);
      if (depth > 0.0 || lattice.grown_to[i] == kNeighbour[side])
        F[i] += (kContact * area[i] * depth) * normal;
    }
  }
}

void add_pressure(const LeafletLattice& lattice, double pressure, std::span<const Vec3> X, std::span<Vec3> F)
{
  for (const std::array<int, 3>& t : lattice.triangles) {
    const Vec3 share = (pressure / 3.0) * area_vector(t, X);
    for (int node : t) F[at(node)] -= share;
  }
}

/// Per node a bound of the stiffness acting on it (row sums), dyn/cm: with these as masses every frequency is
/// below 1, and relaxation is stable up to a time step of 2.
std::vector<double> fictitious_masses(const LeafletLattice& lattice, const std::vector<double>& area,
                                      double pressure)
{
  std::vector<double> mass(area.size());
  for (std::size_t i = 0; i < mass.size(); ++i)
    mass[i] = 2.0 * kContact * area[i] + pressure * (lattice.row_distance + lattice.column_distance);
  const Springs& springs = lattice.network.springs;
  for (std::size_t n = 0; n < springs.a.size(); ++n) {
    const double k = 2.0 * springs.stiffness[n] / springs.rest_length[n];
    mass[at(springs.a[n])] += k;
    mass[at(springs.b[n])] += k;
  }
  const Beams& beams = lattice.network.beams;
  for (std::size_t n = 0; n < beams.x0.size(); ++n) {
    const double g0 = 1.0 / beams.l1[n], g2 = 1.0 / beams.l2[n];
    const double c = 2.0 * beams.rigidity[n] / (beams.l1[n] + beams.l2[n]) * 2.0 * (g0 + g2);
    mass[at(beams.x0[n])] += c * g0;
    mass[at(beams.x1[n])] += c * (g0 + g2);
    mass[at(beams.x2[n])] += c * g2;
  }
  return mass;
}

/// The state of a relaxation: one FIRE step after another until the force is small.
class Relaxation {
 public:
  Relaxation(const LeafletLattice& lattice, double pressure, std::span<const Vec3> guess)
      : lattice_(lattice),
        pressure_(pressure),
        area_(reference_areas(lattice)),
        mass_(fictitious_masses(lattice, area_, pressure)),
        X_(guess.begin(), guess.end()),
        V_(guess.size(), Vec3{0.0, 0.0, 0.0}),
        F_(guess.size())
  {
    for (std::size_t i = 0; i < X_.size(); ++i) {
      if (lattice.on_edge[i] != 0) continue;
      const double force = pressure * area_[i];
      load_squared_ += force * force;
    }
    update_force();
  }

  double residual() const
  {
    double sum = 0.0;
    for (const Vec3& f : F_) sum += dot(f, f);
    return std::sqrt(sum / load_squared_);
  }

  void step()
  {
    double power = 0.0, vv = 0.0, ff = 0.0;
    for (std::size_t i = 0; i < X_.size(); ++i) {
      power += dot(F_[i], V_[i]);
      vv += mass_[i] * dot(V_[i], V_[i]);
      ff += dot(F_[i], F_[i]) / mass_[i];
    }
    if (power > 0.0) {
      if (++downhill_ > 5) {
        dt_ = std::min(1.1 * dt_, kLargestStep);
        mixing_ *= 0.99;
      }
    } else {
      downhill_ = 0;
      dt_ *= 0.5;
      mixing_ = kMixing;
      vv = 0.0;
      std::fill(V_.begin(), V_.end(), Vec3{0.0, 0.0, 0.0});
    }
    const double turn = ff > 0.0 ? mixing_ * std::sqrt(vv / ff) : 0.0;
    for (std::size_t i = 0; i < X_.size(); ++i) {
      V_[i] = (1.0 - mixing_) * V_[i] + ((turn + dt_) / mass_[i]) * F_[i];
      X_[i] += dt_ * V_[i];
    }
    update_force();
  }

  std::vector<Vec3> take_positions() { return std::move(X_); }

 private:
  static constexpr double kLargestStep = 1.2, kMixing = 0.1;

  void update_force()
  {
    std::fill(F_.begin(), F_.end(), Vec3{0.0, 0.0, 0.0});
    add_fibre_force(lattice_.network, X_, F_);
    add_pressure(lattice_, pressure_, X_, F_);
    add_contact(lattice_, area_, X_, F_);
    for (std::size_t i = 0; i < X_.size(); ++i)
      if (lattice_.on_edge[i] != 0) F_[i] = Vec3{0.0, 0.0, 0.0};
  }

  const LeafletLattice& lattice_;
  double pressure_;
  std::vector<double> area_, mass_;
  std::vector<Vec3> X_, V_, F_;
  double load_squared_ = 0.0, dt_ = 0.5, mixing_ = kMixing;
  int downhill_ = 0;
};

double distance_to_neighbour_plane(const Vec3& x)
{
  return std::min(dot(kPlaneNormal[0], x), dot(kPlaneNormal[1], x));
}

bool is_pressed(const LeafletLattice& lattice, std::size_t node, const Vec3& x)
{
  return std::any_of(std::begin(kPlaneNormal), std::end(kPlaneNormal),
                     [&](const Vec3& normal) { return dot(normal, x) < gap_of(lattice, node, normal); });
}

/// Height of the middle column's upper part that is within 1 mm of the neighbours, interpolated between
/// nodes.
double coaptation_height(const std::vector<int>& middle, std::span<const Vec3> X)
{
  constexpr double kClose = 0.05;  // cm to the plane: half the distance to the neighbour
  const Vec3 top = X[at(middle[0])];
  double above = distance_to_neighbour_plane(top);
  if (above >= kClose) return 0.0;
  for (std::size_t k = 1; k < middle.size(); ++k) {
    const Vec3 x = X[at(middle[k])], previous = X[at(middle[k - 1])];
    const double here = distance_to_neighbour_plane(x);
    if (here >= kClose)
      return top[2] - previous[2] + (previous[2] - x[2]) * (kClose - above) / (here - above);
    above = here;
  }
  return top[2] - X[at(middle.back())][2];
}

double length_of(const std::vector<int>& line, std::span<const Vec3> X)
{
  double length = 0.0;
  for (std::size_t k = 1; k < line.size(); ++k) length += norm(X[at(line[k])] - X[at(line[k - 1])]);
  return length;
}

void measure(const LeafletLattice& lattice, const LeafletMaterial& material, std::span<const Vec3> X,
             LeafletShape& shape)
{
  const NodeGroup& all = lattice.network.groups.front();
  const Strain rows = fibre_strain(lattice.network, X, all, SpringFamily::tension_only);
  const Strain columns = fibre_strain(lattice.network, X, all, SpringFamily::two_sided);
  shape.circumferential_strain_mean = rows.mean;
  shape.circumferential_strain_max = rows.largest;
  shape.radial_strain_mean = columns.mean;
  shape.radial_strain_max = columns.largest;
  shape.tension_mean = material.circumferential_stiffness * rows.mean;
  shape.tension_max = material.circumferential_stiffness * rows.largest;

  const std::vector<double> area = reference_areas(lattice);
  for (std::size_t i = 0; i < X.size(); ++i)
    if (lattice.on_edge[i] == 0 && is_pressed(lattice, i, X[i])) shape.contact_area_cm2 += area[i];
  shape.coaptation_height_cm = coaptation_height(lattice.middle, X);
  shape.free_edge_length_cm = length_of(lattice.network.free_edges.front(), X);
  shape.middle_length_cm = length_of(lattice.middle, X);
}

}  // namespace

std::vector<Vec3> closed_leaflet_guess(const RootDimensions& root, const LeafletLattice& lattice)
{
  std::vector<Vec3> X = lattice.network.X;
  const double Ra = leaflet_half_width(root), H = root.commissure_height;
  for (std::size_t i = 0; i < X.size(); ++i) {
    if (lattice.on_edge[i] != 0) continue;
    const double begin = attachment_height(root, lattice.s[i]);
    const double closed = std::sqrt((lattice.z[i] - begin) / (H - begin));
    const double r = root.annulus_radius * std::abs(lattice.s[i]) / Ra;
    const Vec3 coapted{0.5 * r, std::copysign(kSqrt3Half * r, lattice.s[i]), X[i][2] - 0.2 * H * (1.0 - r)};
    X[i] += closed * (coapted - X[i]);
  }
  return X;
}

void leaflet_load(const LeafletLattice& lattice, double pressure, std::span<const Vec3> X, std::span<Vec3> F)
{
  std::fill(F.begin(), F.end(), Vec3{0.0, 0.0, 0.0});
  add_pressure(lattice, pressure, X, F);
  add_contact(lattice, reference_areas(lattice), X, F);
}

LeafletEquilibrium find_leaflet_equilibrium(const LeafletLattice& lattice, const LeafletMaterial& material,
                                            double pressure_mmHg, std::span<const Vec3> guess)
{
  Relaxation relaxation(lattice, common::dyn_cm2_from_mmHg(pressure_mmHg), guess);
  LeafletEquilibrium found;
  found.shape.pressure_mmHg = pressure_mmHg;
  double residual = relaxation.residual();
  while (residual > kEquilibriumResidual && found.shape.iterations < kMaxIterations &&
         std::isfinite(residual)) {
    relaxation.step();
    residual = relaxation.residual();
    ++found.shape.iterations;
  }
  found.shape.residual = residual;
  if (!(residual <= kEquilibriumResidual))
    throw SolverError(fmt::format(
        "Leaflet form-finding: no equilibrium under {:.6g} mmHg after {} relaxation steps, residual {:.3g} "
        "(wanted {:.3g}); try stiffer leaflets ([leaflets] bending or stiffness) or rest ratios closer to 1.",
        pressure_mmHg, found.shape.iterations, residual, kEquilibriumResidual));
  found.X = relaxation.take_positions();
  measure(lattice, material, found.X, found.shape);
  return found;
}

}  // namespace valsalva::ib3d
