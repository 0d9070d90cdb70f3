// Markers as VTKHDF UnstructuredGrid: every one a vertex.
#include "common/error.hpp"
#include "ib3d/output/vtkhdf_pieces.hpp"

namespace valsalva::ib3d {

void write_markers(const std::string& path, double time_s, const MarkerPicture& markers,
                   const std::vector<std::string>& group_names, MPI_Comm comm)
{
  const std::size_t count = markers.points.size();
  int unfit =
      markers.id.size() == count && markers.group.size() == count && markers.age.size() == count ? 0 : 1;
  MPI_Allreduce(MPI_IN_PLACE, &unfit, 1, MPI_INT, MPI_MAX, comm);
  if (unfit == 1) throw IoError(path + ": the arrays of the markers do not fit together");

  VtkCells cells;
  for (int i = 0; i < static_cast<int>(count); ++i) cells.add(std::span<const int>(&i, 1), kVertex);
  PieceFile file(path, time_s, group_names, markers.points, std::move(cells), comm);
  file.write("PointData/id", markers.id);
  file.write("PointData/group", markers.group);
  file.write("PointData/age_s", markers.age);
  file.close();
}

}  // namespace valsalva::ib3d
