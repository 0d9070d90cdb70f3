// The structure as VTKHDF UnstructuredGrid: one piece per rank that has points.
#include <algorithm>
#include <cstdint>
#include <span>

#include "common/error.hpp"
#include "common/hdf5_file.hpp"
#include "ib3d/output/vtkhdf.hpp"

namespace valsalva::ib3d {
namespace {

constexpr std::uint8_t kVertex = 1, kLine = 3;  // VTK's cell types

/// The cells of one rank in VTK's terms: cell c joins connectivity[offsets[c]] ... [offsets[c + 1] - 1].
struct Cells {
  std::vector<std::int64_t> connectivity, offsets{0};
  std::vector<std::uint8_t> types;
  std::vector<float> strain;

  void add(std::span<const int> points, std::uint8_t type, float value)
  {
    connectivity.insert(connectivity.end(), points.begin(), points.end());
    offsets.push_back(std::ssize(connectivity));
    types.push_back(type);
    strain.push_back(value);
  }
};

Cells cells_of(const FiberPicture& fibers)
{
  Cells cells;
  std::vector<bool> joined(fibers.points.size(), false);
  for (std::size_t l = 0; l < fibers.lines.size(); ++l) {
    cells.add(fibers.lines[l], kLine, fibers.strain[l]);
    for (int i : fibers.lines[l]) joined[static_cast<std::size_t>(i)] = true;
  }
  for (int i = 0; i < static_cast<int>(joined.size()); ++i) {
    if (!joined[static_cast<std::size_t>(i)]) cells.add(std::span<const int>(&i, 1), kVertex, 0.0F);
  }
  if (fibers.points.empty()) cells.offsets.clear();
  return cells;
}

/// Writes the rank's share of an array that is cut at the ranks.
class PieceWriter {
 public:
  PieceWriter(Hdf5File& file, MPI_Comm comm) : file_(file), comm_(comm) {}

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

 private:
  Hdf5File& file_;
  MPI_Comm comm_;
};

std::vector<float> flat(const std::vector<Vec3>& vectors)
{
  std::vector<float> values;
  values.reserve(3 * vectors.size());
  for (const Vec3& v : vectors) {
    for (double c : v.c) values.push_back(static_cast<float>(c));
  }
  return values;
}

std::string one_per_line(const std::vector<std::string>& names)
{
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : "\n") + name;
  return text;
}

bool consistent(const FiberPicture& f)
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

void write_fibers(const std::string& path, double time_s, const FiberPicture& fibers,
                  const std::vector<std::string>& group_names, MPI_Comm comm)
{
  int flags[2] = {consistent(fibers) ? 0 : 1, fibers.force.empty() ? 0 : 1};
  MPI_Allreduce(MPI_IN_PLACE, flags, 2, MPI_INT, MPI_MAX, comm);
  if (flags[0] == 1) throw IoError(path + ": the arrays of the fibres do not fit together");

  const Cells cells = cells_of(fibers);
  Hdf5File file = Hdf5File::create(path, comm);
  file.write_attribute("/", "time_s", std::span<const double>(&time_s, 1));
  file.write_attribute("/", "group_names", one_per_line(group_names));
  for (const char* data : {"/VTKHDF", "/VTKHDF/PointData", "/VTKHDF/CellData", "/VTKHDF/FieldData"}) {
    file.create_group(data);
  }
  file.write_attribute("/VTKHDF", "Version", std::array<std::int64_t, 2>{1, 0});
  file.write_attribute("/VTKHDF", "Type", std::string("UnstructuredGrid"));

  PieceWriter pieces(file, comm);
  std::vector<std::int64_t> counts[3];
  if (!fibers.points.empty()) {
    counts[0] = {std::ssize(fibers.points)};
    counts[1] = {std::ssize(cells.types)};
    counts[2] = {std::ssize(cells.connectivity)};
  }
  pieces.write("NumberOfPoints", counts[0]);
  pieces.write("NumberOfCells", counts[1]);
  pieces.write("NumberOfConnectivityIds", counts[2]);
  pieces.write("Points", flat(fibers.points), 3);
  pieces.write("Connectivity", cells.connectivity);
  pieces.write("Offsets", cells.offsets);
  pieces.write("Types", cells.types);
  pieces.write("PointData/group", fibers.group);
  if (flags[1] == 1) pieces.write("PointData/force_dyn", flat(fibers.force), 3);
  pieces.write("CellData/strain", cells.strain);
  file.close();
}

}  // namespace valsalva::ib3d
