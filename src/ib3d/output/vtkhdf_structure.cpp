// The structure as VTKHDF UnstructuredGrid: elements as lines or triangles, points without one as vertices.
#include <algorithm>

#include "common/error.hpp"
#include "ib3d/output/vtkhdf_pieces.hpp"

namespace valsalva::ib3d {
namespace {

bool consistent(const StructurePicture& s)
{
  const int n = static_cast<int>(s.points.size());
  const std::vector<int>& joined = s.elements.nodes;
  return s.group.size() == s.points.size() && std::ssize(s.strain) == s.elements.count() &&
         (s.force.empty() || s.force.size() == s.points.size()) &&
         std::all_of(joined.begin(), joined.end(), [n](int i) { return i >= 0 && i < n; });
}

}  // namespace

void write_structure(const std::string& path, double time_s, const StructurePicture& structure,
                     const std::vector<std::string>& group_names, MPI_Comm comm)
{
  int flags[2] = {consistent(structure) ? 0 : 1, structure.force.empty() ? 0 : 1};
  MPI_Allreduce(MPI_IN_PLACE, flags, 2, MPI_INT, MPI_MAX, comm);
  if (flags[0] == 1) throw IoError(path + ": the arrays of the structure do not fit together");

  VtkCells cells;
  std::vector<float> strain = structure.strain;
  std::vector<bool> joined(structure.points.size(), false);
  for (int e = 0; e < structure.elements.count(); ++e) {
    const std::span<const int> points = structure.elements[e];
    cells.add(points, points.size() == 2 ? kLine : kTriangle);
    for (int i : points) joined[static_cast<std::size_t>(i)] = true;
  }
  for (int i = 0; i < static_cast<int>(joined.size()); ++i) {
    if (!joined[static_cast<std::size_t>(i)]) cells.add(std::span<const int>(&i, 1), kVertex);
  }
  strain.resize(cells.types.size(), 0.0F);

  PieceFile file(path, time_s, group_names, structure.points, std::move(cells), comm);
  file.write("PointData/group", structure.group);
  if (flags[1] == 1) file.write("PointData/force_dyn", structure.force);
  file.write("CellData/strain", strain);
  file.close();
}

}  // namespace valsalva::ib3d
