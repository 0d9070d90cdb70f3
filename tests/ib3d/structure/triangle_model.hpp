// Another elastic model than fibres, for tests of the seam: linear finite elements of a membrane (St. Venant-Kirchhoff),
//     E = sum_triangles A (mu |e|^2 + lambda/2 tr(e)^2),   e = (D^T D - 1)/2,   D = [x1 - x0, x2 - x0] B^{-1}
// with A (cm^2) and B (2 x 2, cm) of the triangle at rest, mu and lambda in dyn/cm. All nodes slip with one velocity.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cmath>

#include "ib3d/structure/elastic_model.hpp"

namespace valsalva::ib3d {

class TriangleModel final : public ElasticModel {
 public:
  struct Triangle {
    std::array<int, 3> node;
    Eigen::Matrix2d B_inverse;
    double area;
  };
  using Edges = Eigen::Matrix<double, 3, 2>;

  TriangleModel(std::vector<Vec3> start, std::vector<Triangle> triangles, const Vec3& slip)
      : start_(std::move(start)), triangles_(std::move(triangles)), slip_(slip)
  {
  }

  const std::vector<Vec3>& start() const override { return start_; }
  const std::vector<NodeGroup>& groups() const override { return groups_; }
  void add_force(std::span<const Vec3> X, std::span<Vec3> F) const override
  {
    for (const Triangle& t : triangles_) {
      const Edges D = edges(t, X) * t.B_inverse;
      add_to_nodes(t, -t.area * D * stress(strain(D)) * t.B_inverse.transpose(), F);
    }
  }
  double energy(std::span<const Vec3> X) const override
  {
    double sum = 0;
    for (const Triangle& t : triangles_) {
      const Eigen::Matrix2d e = strain(edges(t, X) * t.B_inverse);
      sum += 0.5 * t.area * (stress(e).transpose() * e).trace();
    }
    return sum;
  }
  void add_stiffness_times(std::span<const Vec3> X, std::span<const Vec3> v,
                           std::span<Vec3> Kv) const override
  {
    for (const Triangle& t : triangles_) {
      const Edges D = edges(t, X) * t.B_inverse, dD = edges(t, v) * t.B_inverse;
      const Eigen::Matrix2d de = 0.5 * (D.transpose() * dD + dD.transpose() * D);
      add_to_nodes(t, t.area * (dD * stress(strain(D)) + D * stress(de)) * t.B_inverse.transpose(), Kv);
    }
  }
  void add_slip(std::span<const Vec3> /*X*/, double /*dt*/, std::span<Vec3> U) const override
  {
    for (Vec3& u : U) u += slip_;
  }
  Elements elements() const override
  {
    Elements all;
    for (const Triangle& t : triangles_) all.add(t.node);
    return all;
  }
  std::unique_ptr<const ElasticModel> part(const Selection& selection) const override
  {
    std::vector<Vec3> start;
    std::vector<Triangle> triangles;
    for (const int n : selection.nodes) start.push_back(start_[static_cast<std::size_t>(n)]);
    for (const int e : selection.elements) {
      triangles.push_back(triangles_[static_cast<std::size_t>(e)]);
      for (int& n : triangles.back().node) n = selection.number[static_cast<std::size_t>(n)];
    }
    return std::make_unique<TriangleModel>(std::move(start), std::move(triangles), slip_);
  }
  Deformation deformation(std::span<const Vec3> /*X*/) const override { return {}; }
  StrainedElements drawing(std::span<const Vec3> /*X*/) const override
  {
    return {elements(), std::vector<double>(triangles_.size(), 0.0)};
  }

 private:
  static constexpr double kMu = 400, kLambda = 300;

  static Eigen::Vector3d vector(const Vec3& x) { return {x[0], x[1], x[2]}; }
  static Edges edges(const Triangle& t, std::span<const Vec3> X)
  {
    const auto at = [&](std::size_t n) { return vector(X[static_cast<std::size_t>(t.node[n])]); };
    Edges e;
    e << at(1) - at(0), at(2) - at(0);
    return e;
  }
  static Eigen::Matrix2d strain(const Edges& D)
  {
    return 0.5 * (D.transpose() * D - Eigen::Matrix2d::Identity());
  }
  static Eigen::Matrix2d stress(const Eigen::Matrix2d& e)
  {
    return 2 * kMu * e + kLambda * e.trace() * Eigen::Matrix2d::Identity();
  }
  /// What acts on the two edges, to their ends.
  static void add_to_nodes(const Triangle& t, const Edges& on_edges, std::span<Vec3> F)
  {
    for (std::size_t k = 0; k < 2; ++k) {
      const Eigen::Vector3d f = on_edges.col(static_cast<Eigen::Index>(k));
      const Vec3 force{f[0], f[1], f[2]};
      F[static_cast<std::size_t>(t.node[k + 1])] += force;
      F[static_cast<std::size_t>(t.node[0])] -= force;
    }
  }

  std::vector<Vec3> start_;
  std::vector<Triangle> triangles_;
  Vec3 slip_;
  std::vector<NodeGroup> groups_;
};

/// A sheet of `width` cm about `centre`, bulged and `stretch` times as wide as at rest, of 2 n^2 triangles.
inline std::unique_ptr<TriangleModel> stretched_sheet(const Vec3& centre, double width, int n, double stretch,
                                                      const Vec3& slip = {0, 0, 0})
{
  std::vector<Vec3> start;
  const double h = width / n, rest = h / stretch;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      start.push_back(centre + Vec3{h * i - 0.5 * width, h * j - 0.5 * width,
                                    0.2 * width * std::sin(2.0 * i / n) * std::cos(3.0 * j / n)});
  std::vector<TriangleModel::Triangle> triangles;
  const Eigen::Matrix2d B_inverse = Eigen::Matrix2d::Identity() / rest;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int corner = i + (n + 1) * j;
      triangles.push_back({{corner, corner + 1, corner + n + 1}, B_inverse, 0.5 * rest * rest});
      triangles.push_back({{corner + n + 2, corner + n + 1, corner + 1}, B_inverse, 0.5 * rest * rest});
    }
  return std::make_unique<TriangleModel>(std::move(start), std::move(triangles), slip);
}

}  // namespace valsalva::ib3d
