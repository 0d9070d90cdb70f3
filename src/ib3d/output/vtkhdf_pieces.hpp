// What the VTKHDF UnstructuredGrid files of the structure and of the markers have in common: points and cells in one
// piece per rank that has points, in the order of the ranks. Collective.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/hdf5_file.hpp"
#include "ib3d/output/vtkhdf.hpp"

namespace valsalva::ib3d {

inline constexpr std::uint8_t kVertex = 1, kLine = 3, kTriangle = 5;  // VTK's cell types

/// The cells of one rank in VTK's terms: cell c joins connectivity[offsets[c]] ... [offsets[c + 1] - 1].
struct VtkCells {
  std::vector<std::int64_t> connectivity, offsets{0};
  std::vector<std::uint8_t> types;

  void add(std::span<const int> points, std::uint8_t type)
  {
    connectivity.insert(connectivity.end(), points.begin(), points.end());
    offsets.push_back(std::ssize(connectivity));
    types.push_back(type);
  }
};

class PieceFile {
 public:
  /// Creates the file and writes points (cm) and cells; `group_names[g]` is the name of group g.
  PieceFile(const std::string& path, double time_s, const std::vector<std::string>& group_names,
            const std::vector<Vec3>& points, VtkCells cells, MPI_Comm comm);

  /// Writes this rank's share of an array that is cut at the ranks, `width` values a row, e.g. "PointData/group".
  template <class T>
  void write(const std::string& name, const std::vector<T>& values, std::int64_t width = 1)
  {
    const std::int64_t rows = std::ssize(values) / width;
    std::int64_t end = 0, total = 0;
    MPI_Scan(&rows, &end, 1, MPI_INT64_T, MPI_SUM, comm_);
    MPI_Allreduce(&rows, &total, 1, MPI_INT64_T, MPI_SUM, comm_);
    const Slab slab = width == 1 ? Slab{{end - rows}, {rows}} : Slab{{end - rows, 0}, {rows, width}};
    const common::Shape shape = width == 1 ? common::Shape{total} : common::Shape{total, width};
    file_.write("/VTKHDF/" + name, shape, std::span<const Slab>(&slab, 1), std::span<const T>(values));
  }
  void write(const std::string& name, const std::vector<Vec3>& vectors);
  void close() { file_.close(); }

 private:
  Hdf5File file_;
  MPI_Comm comm_;
};

}  // namespace valsalva::ib3d
