// The structure as VTKHDF UnstructuredGrid: springs as lines, points without one as vertices.
#include <algorithm>

#include "common/error.hpp"
#include "ib3d/output/vtkhdf_pieces.hpp"

namespace valsalva::ib3d {
namespace {

bool consistent(const FibrePicture& f)
{
  const int n = static_cast<int>(f.points.size());
  const auto known = [n](const std::array<int, 2>& l) {
    return std::min(l[0], l[1]) >= 0 && std::max(l[0], l[1]) < n;
  };
  return f.group.size() == f.points.size() && f.strain.size() == f.lines.size() &&
         (f.force.empty() || f.force.size() == f.points.size()) &&
         std::all_of(f.lines.begin(), f.lines.end(), known);
}

}  // namespace

void write_fibres(const std::string& path, double time_s, const FibrePicture& fibres,
                  const std::vector<std::string>& group_names, MPI_Comm comm)
{
  int flags[2] = {consistent(fibres) ? 0 : 1, fibres.force.empty() ? 0 : 1};
  MPI_Allreduce(MPI_IN_PLACE, flags, 2, MPI_INT, MPI_MAX, comm);
  if (flags[0] == 1) throw IoError(path + ": the arrays of the fibres do not fit together");

  VtkCells cells;
  std::vector<float> strain = fibres.strain;
  std::vector<bool> joined(fibres.points.size(), false);
  for (const std::array<int, 2>& line : fibres.lines) {
    cells.add(line, kLine);
    for (int i : line) joined[static_cast<std::size_t>(i)] = true;
  }
  for (int i = 0; i < static_cast<int>(joined.size()); ++i) {
    if (!joined[static_cast<std::size_t>(i)]) cells.add(std::span<const int>(&i, 1), kVertex);
  }
  strain.resize(cells.types.size(), 0.0F);

  PieceFile file(path, time_s, group_names, fibres.points, std::move(cells), comm);
  file.write("PointData/group", fibres.group);
  if (flags[1] == 1) file.write("PointData/force_dyn", fibres.force);
  file.write("CellData/strain", strain);
  file.close();
}

}  // namespace valsalva::ib3d
