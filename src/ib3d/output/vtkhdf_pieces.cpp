#include "ib3d/output/vtkhdf_pieces.hpp"

#include "common/comm.hpp"

namespace valsalva::ib3d {

namespace {

std::string one_per_line(const std::vector<std::string>& names)
{
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : "\n") + name;
  return text;
}

}  // namespace

PieceFile::PieceFile(const std::string& path, double time_s, const std::vector<std::string>& group_names,
                     const std::vector<Vec3>& points, VtkCells cells, MPI_Comm comm)
    : file_(Hdf5File::create(path, comm)), comm_(comm)
{
  file_.write_attribute("/", "time_s", std::span<const double>(&time_s, 1));
  file_.write_attribute("/", "group_names", one_per_line(group_names));
  for (const char* data : {"/VTKHDF", "/VTKHDF/PointData", "/VTKHDF/CellData", "/VTKHDF/FieldData"}) {
    file_.create_group(data);
  }
  file_.write_attribute("/VTKHDF", "Version", std::array<std::int64_t, 2>{1, 0});
  file_.write_attribute("/VTKHDF", "Type", std::string("UnstructuredGrid"));

  const Communicator ranks(comm);
  const bool some = ranks.any(!points.empty());
  const bool has_piece =
      !points.empty() || (!some && ranks.is_rank_0());  // ParaView reads no file without a piece
  std::vector<std::int64_t> counts[3];
  if (!has_piece) {
    cells.offsets.clear();
  } else {
    counts[0] = {std::ssize(points)};
    counts[1] = {std::ssize(cells.types)};
    counts[2] = {std::ssize(cells.connectivity)};
  }
  write("NumberOfPoints", counts[0]);
  write("NumberOfCells", counts[1]);
  write("NumberOfConnectivityIds", counts[2]);
  write("Points", points);
  write("Connectivity", cells.connectivity);
  write("Offsets", cells.offsets);
  write("Types", cells.types);
}

void PieceFile::write(const std::string& name, const std::vector<Vec3>& vectors)
{
  std::vector<float> values;
  values.reserve(3 * vectors.size());
  for (const Vec3& v : vectors) {
    for (double c : v.c) values.push_back(static_cast<float>(c));
  }
  write(name, values, 3);
}

}  // namespace valsalva::ib3d
