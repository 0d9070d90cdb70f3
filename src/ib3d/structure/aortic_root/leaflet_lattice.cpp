#include "ib3d/structure/aortic_root/leaflet_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "ib3d/structure/aortic_root/root_shape.hpp"

namespace valsalva::ib3d {

namespace {

class LatticeBuilder {
 public:
  LatticeBuilder(const RootDimensions& root, const LeafletMaterial& material, double h)
      : root_(root), material_(material)
  {
    const double Ra = leaflet_half_width(root), H = root.commissure_height;
    const double widest = std::max({material.circumferential_rest_ratio, material.free_edge_rest_ratio, 1.0});
    half_columns_ = static_cast<int>(std::ceil(Ra * widest / (0.5 * h)));
    rows_ = static_cast<int>(std::ceil(H * std::max(material.radial_rest_ratio, 1.0) / (0.5 * h)));
    ds_ = Ra / half_columns_;
    dz_ = H / rows_;
  }

  LeafletLattice build()
  {
    lattice_.row_distance = dz_;
    lattice_.column_distance = ds_;
    add_nodes();
    add_rows();
    add_columns();
    add_cells();
    add_rim(+1);
    add_rim(-1);
    for (int node : column_from_top(0)) lattice_.middle.push_back(node);
    lattice_.network.free_edges.push_back(row_from_left(0));
    lattice_.network.groups.push_back(NodeGroup{"leaflet", 0, lattice_.network.node_count()});
    return std::move(lattice_);
  }

 private:
  double s_of(int i) const { return i * ds_; }
  double z_of(int j) const { return root_.commissure_height - j * dz_; }

  bool is_interior(int i, int j) const
  {
    if (j < 0 || j >= rows_ || std::abs(i) >= half_columns_) return false;
    return std::abs(s_of(i)) < attachment_half_width(root_, z_of(j)) - 0.5 * ds_ &&
           z_of(j) > attachment_height(root_, s_of(i)) + 0.5 * dz_;
  }
  /// Number of a lattice node, or -1.
  int& number(int i, int j)
  {
    return numbers_[static_cast<std::size_t>(j * (2 * half_columns_ + 1) + i + half_columns_)];
  }
  int add_node(double s, double z, bool on_edge)
  {
    const double R = root_.annulus_radius, theta = s / R;
    lattice_.network.X.push_back({R * std::cos(theta), R * std::sin(theta), root_.annulus_z + z});
    lattice_.s.push_back(s);
    lattice_.z.push_back(z);
    lattice_.on_edge.push_back(on_edge ? 1 : 0);
    lattice_.fused_to.push_back(0);
    return lattice_.network.node_count() - 1;
  }

  void add_nodes()
  {
    numbers_.assign(static_cast<std::size_t>(rows_ * (2 * half_columns_ + 1)), -1);
    for (int j = 0; j < rows_ && is_interior(0, j); ++j) {
      const double half_width = attachment_half_width(root_, z_of(j));
      row_ends_.push_back({add_node(-half_width, z_of(j), true), -1});
      for (int i = -half_columns_ + 1; i < half_columns_; ++i)
        if (is_interior(i, j)) number(i, j) = add_node(s_of(i), z_of(j), false);
      row_ends_.back()[1] = add_node(half_width, z_of(j), true);
    }
    column_ends_.assign(static_cast<std::size_t>(2 * half_columns_ + 1), -1);
    for (int i = -half_columns_ + 1; i < half_columns_; ++i)
      if (is_interior(i, 0)) column_end(i) = add_node(s_of(i), attachment_height(root_, s_of(i)), true);
  }

  int& column_end(int i) { return column_ends_[static_cast<std::size_t>(i + half_columns_)]; }

  std::vector<int> row_from_left(int j)
  {
    std::vector<int> line{row_ends_[static_cast<std::size_t>(j)][0]};
    for (int i = -half_columns_ + 1; i < half_columns_; ++i)
      if (is_interior(i, j)) line.push_back(number(i, j));
    line.push_back(row_ends_[static_cast<std::size_t>(j)][1]);
    return line;
  }
  std::vector<int> column_from_top(int i)
  {
    std::vector<int> line;
    for (int j = 0; is_interior(i, j); ++j) line.push_back(number(i, j));
    line.push_back(column_end(i));
    return line;
  }

  double distance(int a, int b) const
  {
    const auto m = static_cast<std::size_t>(a), n = static_cast<std::size_t>(b);
    return std::hypot(lattice_.s[m] - lattice_.s[n], lattice_.z[m] - lattice_.z[n]);
  }

  /// Springs and beams along a line of nodes; stiffness and bending per unit width, `width` its share (cm).
  void add_fibre(const std::vector<int>& line, double width, double stiffness, double bending,
                 double rest_ratio, bool tension_only)
  {
    for (std::size_t k = 0; k + 1 < line.size(); ++k)
      lattice_.network.springs.add(line[k], line[k + 1], stiffness * width,
                                   rest_ratio * distance(line[k], line[k + 1]), tension_only);
    if (bending == 0.0) return;
    for (std::size_t k = 0; k + 2 < line.size(); ++k)
      lattice_.network.beams.add({line[k], line[k + 1], line[k + 2]}, bending * width,
                                 rest_ratio * distance(line[k], line[k + 1]),
                                 rest_ratio * distance(line[k + 1], line[k + 2]));
  }
  void add_rows()
  {
    for (int j = 0; j < static_cast<int>(row_ends_.size()); ++j) {
      const double near_edge = smooth_step((z_of(j) / root_.commissure_height - 0.3) / 0.7);
      const double rest_ratio =
          material_.circumferential_rest_ratio +
          (material_.free_edge_rest_ratio - material_.circumferential_rest_ratio) * near_edge;
      add_fibre(row_from_left(j), j == 0 ? 0.5 * dz_ : dz_, material_.circumferential_stiffness,
                material_.circumferential_bending, rest_ratio, true);
    }
  }
  void add_columns()
  {
    for (int i = -half_columns_ + 1; i < half_columns_; ++i)
      if (is_interior(i, 0))
        add_fibre(column_from_top(i), ds_, material_.radial_stiffness, material_.radial_bending,
                  material_.radial_rest_ratio, false);
  }

  void add_triangle(int a, int b, int c)
  {
    const auto m = static_cast<std::size_t>(a), n = static_cast<std::size_t>(b),
               q = static_cast<std::size_t>(c);
    const double twice_area = (lattice_.s[n] - lattice_.s[m]) * (lattice_.z[q] - lattice_.z[m]) -
                              (lattice_.z[n] - lattice_.z[m]) * (lattice_.s[q] - lattice_.s[m]);
    if (twice_area > 0.0) lattice_.triangles.push_back({a, b, c});
    if (twice_area < 0.0) lattice_.triangles.push_back({a, c, b});
  }
  /// Whole lattice cells, cut along diagonals that mirror each other in s = 0.
  void add_cells()
  {
    for (int j = 0; j + 1 < static_cast<int>(row_ends_.size()); ++j) {
      for (int i = 0; is_interior(i + 1, j + 1); ++i) {
        for (int side : {+1, -1}) {
          const int inner = side * i, outer = side * (i + 1);
          add_triangle(number(inner, j), number(outer, j), number(inner, j + 1));
          add_triangle(number(outer, j), number(outer, j + 1), number(inner, j + 1));
        }
      }
    }
  }
  /// The strip between the lattice's staircase border and the attachment line, on one side of s = 0: two
  /// chains of nodes from the bottom to the commissure, joined like a zip by their shorter diagonals.
  void add_rim(int side)
  {
    std::vector<int> stairs, edge;
    for (int i = 0; is_interior(side * i, 0); ++i) {
      for (int j = rows_ - 1; j >= 0; --j)
        if (is_interior(side * i, j) && !is_interior(side * (i + 1), j + 1))
          stairs.push_back(number(side * i, j));
      edge.push_back(column_end(side * i));
    }
    for (const std::array<int, 2>& ends : row_ends_) edge.push_back(ends[side > 0 ? 1 : 0]);
    std::sort(edge.begin(), edge.end(), [&](int a, int b) {
      const auto m = static_cast<std::size_t>(a), n = static_cast<std::size_t>(b);
      return std::abs(lattice_.s[m]) < std::abs(lattice_.s[n]);
    });
    std::size_t m = 0, n = 0;
    while (m + 1 < stairs.size() || n + 1 < edge.size()) {
      const bool along_edge =
          m + 1 == stairs.size() ||
          (n + 1 < edge.size() && distance(stairs[m], edge[n + 1]) < distance(stairs[m + 1], edge[n]));
      if (along_edge) {
        add_triangle(stairs[m], edge[n], edge[n + 1]);
        ++n;
      } else {
        add_triangle(stairs[m], edge[n], stairs[m + 1]);
        ++m;
      }
    }
  }

  const RootDimensions& root_;
  const LeafletMaterial& material_;
  int half_columns_ = 0, rows_ = 0;
  double ds_ = 0.0, dz_ = 0.0;
  std::vector<int> numbers_, column_ends_;
  std::vector<std::array<int, 2>> row_ends_;
  LeafletLattice lattice_;
};

}  // namespace

LeafletLattice leaflet_lattice(const RootDimensions& root, const LeafletMaterial& material, double h)
{
  return LatticeBuilder(root, material, h).build();
}

}  // namespace valsalva::ib3d
