#include "ib3d/structure/aortic_root/root_wall.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "ib3d/structure/aortic_root/root_shape.hpp"

namespace valsalva::ib3d {

namespace {

using std::numbers::pi;

/// The surface r(theta, z) of one layer and its metric.
class LayerSurface {
 public:
  LayerSurface(const RootDimensions& root, double h, double offset) : root_(root), h_(h), offset_(offset) {}

  double radius(double theta, double z) const { return wall_radius(root_, h_, theta, z) + offset_; }
  double slope_theta(double theta, double z) const
  {
    return (radius(theta + kStep, z) - radius(theta - kStep, z)) / (2.0 * kStep);
  }
  double slope_z(double theta, double z) const
  {
    const double low = std::max(z - kStep, 0.0), high = std::min(z + kStep, root_.length);
    return (radius(theta, high) - radius(theta, low)) / (high - low);
  }
  /// Area per d(theta) dz.
  double area_element(double theta, double z) const
  {
    const double r = radius(theta, z), rt = slope_theta(theta, z), rz = slope_z(theta, z);
    return std::sqrt(r * r + rt * rt + r * r * rz * rz);
  }
  /// Largest arc length per dz, over theta.
  double stretch_z(double z) const
  {
    double largest = 0.0;
    for (int k = 0; k <= kSamples; ++k) largest = std::max(largest, std::hypot(1.0, slope_z(angle(k), z)));
    return largest;
  }
  /// Largest arc length per d(theta), over theta.
  double stretch_theta(double z) const
  {
    double largest = 0.0;
    for (int k = 0; k <= kSamples; ++k)
      largest = std::max(largest, std::hypot(radius(angle(k), z), slope_theta(angle(k), z)));
    return largest;
  }

 private:
  static constexpr double kStep = 1e-5;
  static constexpr int kSamples = 16;
  static double angle(int k) { return pi / 3.0 * k / kSamples; }  // half a sinus; the rest is symmetry

  const RootDimensions& root_;
  double h_, offset_;
};

/// Heights of the rows: from end to end, equal steps of the largest arc length along the vessel.
std::vector<double> row_heights(const LayerSurface& surface, double length, double spacing)
{
  const int fine = std::max(200, static_cast<int>(std::ceil(8.0 * length / spacing)));
  const double dz = length / fine;
  std::vector<double> arc{0.0};
  for (int i = 0; i < fine; ++i) arc.push_back(arc.back() + dz * surface.stretch_z((i + 0.5) * dz));

  const int intervals = static_cast<int>(std::ceil(arc.back() / spacing));
  std::vector<double> z{0.0};
  std::size_t i = 0;
  for (int row = 1; row < intervals; ++row) {
    const double wanted = arc.back() * row / intervals;
    while (arc[i + 1] < wanted) ++i;
    z.push_back(dz * (static_cast<double>(i) + (wanted - arc[i]) / (arc[i + 1] - arc[i])));
  }
  z.push_back(length);
  return z;
}

}  // namespace

WallLayer wall_layer(const RootDimensions& root, double h, double offset, double spacing)
{
  const LayerSurface surface(root, h, offset);
  const std::vector<double> z = row_heights(surface, root.length, spacing);
  WallLayer layer;
  for (std::size_t row = 0; row < z.size(); ++row) {
    const double below = z[row] - z[row == 0 ? row : row - 1];
    const double above = z[row + 1 == z.size() ? row : row + 1] - z[row];
    const int per_third =
        static_cast<int>(std::ceil(2.0 * pi * surface.stretch_theta(z[row]) / (3.0 * spacing)));
    const double dtheta = 2.0 * pi / (3 * per_third);
    const double shift = row % 2 == 0 ? 0.0 : 0.5;  // neighbouring rows are staggered
    for (int k = 0; k < 3 * per_third; ++k) {
      const double theta = (k + shift) * dtheta;
      const double r = surface.radius(theta, z[row]);
      layer.X.push_back({root.centre[0] + r * std::cos(theta), root.centre[1] + r * std::sin(theta), z[row]});
      layer.area.push_back(surface.area_element(theta, z[row]) * dtheta * 0.5 * (below + above));
    }
  }
  return layer;
}

void add_wall(const RootDimensions& root, const WallMaterial& material, double h, FibreNetwork& network)
{
  for (int n = 0; n < material.layers; ++n) {
    const double offset = 0.5 * h * n;
    const WallLayer layer = wall_layer(root, h, offset, material.node_spacing_ratio * h);
    const int first = network.node_count();
    for (std::size_t i = 0; i < layer.X.size(); ++i)
      network.tethers.add(first + static_cast<int>(i), material.tether_stiffness * layer.area[i], layer.X[i]);
    network.X.insert(network.X.end(), layer.X.begin(), layer.X.end());
    network.groups.push_back(NodeGroup{"wall " + std::to_string(n + 1), first, network.node_count()});
  }
}

}  // namespace valsalva::ib3d
