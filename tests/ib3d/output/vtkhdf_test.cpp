// Fields and fibres written by all ranks and read back. Also meant for `mpirun -np 2 test_ib3d`.
#include "ib3d/output/vtkhdf.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "common/error.hpp"
#include "common/hdf5_file.hpp"
#include "ib3d/output/mpi_session.hpp"

namespace valsalva::ib3d {
namespace {

const Vec3 kOrigin{-1.0, 0.5, 2.0};

/// A field linear in space: its average over a cell is its value at the centre.
float pressure_at(const Vec3& x)
{
  return static_cast<float>(3.0 + 2.0 * x[0] - x[1] + 0.5 * x[2]);
}
Vec3 velocity_at(const Vec3& x)
{
  return {x[0] + x[1], 4.0 * x[2], 1.0 - x[0]};
}

Vec3 centre(double h, int i, int j, int k)
{
  return kOrigin + Vec3{h * (i + 0.5), h * (j + 0.5), h * (k + 0.5)};
}

/// Boxes are dealt out to the ranks in turn, the last one first.
AmrLevel level_of(double h, const std::vector<IndexBox>& boxes)
{
  AmrLevel level{h, boxes, {}};
  for (int order = static_cast<int>(boxes.size()) - 1; order >= 0; --order) {
    if (order % mpi_size() != mpi_rank()) continue;
    AmrBlock block{order, {}, {}};
    for_each_index(boxes[static_cast<std::size_t>(order)], [&](int i, int j, int k) {
      const Vec3 x = centre(h, i, j, k), u = velocity_at(x);
      for (double c : u.c) block.velocity.push_back(static_cast<float>(c));
      block.pressure.push_back(pressure_at(x));
    });
    level.local.push_back(block);
  }
  return level;
}

std::vector<AmrLevel> two_levels()
{
  return {level_of(0.5, {{{0, 0, 0}, {4, 4, 3}}, {{4, 0, 0}, {8, 4, 3}}, {{0, 4, 0}, {8, 6, 3}}}),
          level_of(0.25, {{{4, 2, 2}, {8, 6, 6}}, {{8, 2, 2}, {12, 8, 4}}})};
}

TEST(OverlappingAmr, LinearFieldReadsBackInEveryCellOfEveryLevel)
{
  const std::string path = shared_file("amr.hdf");
  const std::vector<AmrLevel> levels = two_levels();
  write_overlapping_amr(path, 0.25, kOrigin, levels, MPI_COMM_WORLD);

  const Hdf5File file = Hdf5File::open(path, MPI_COMM_WORLD);
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const std::string group = "/VTKHDF/Level" + std::to_string(l) + "/";
    const auto p = file.read<float>(group + "CellData/pressure_mmHg");
    const auto u = file.read<float>(group + "CellData/velocity_cm_s");
    const auto box = file.read<int>(group + "AMRBox");
    std::size_t cell = 0;
    for (std::size_t b = 0; b < box.size(); b += 6) {
      const IndexBox cells{{box[b], box[b + 2], box[b + 4]},
                           {box[b + 1] + 1, box[b + 3] + 1, box[b + 5] + 1}};
      for_each_index(cells, [&](int i, int j, int k) {
        const Vec3 x = centre(levels[l].spacing, i, j, k), v = velocity_at(x);
        ASSERT_LT(cell, p.size());
        EXPECT_EQ(p[cell], pressure_at(x));
        for (int d = 0; d < 3; ++d) {
          EXPECT_EQ(u[3 * cell + static_cast<std::size_t>(d)], static_cast<float>(v[d]));
        }
        ++cell;
      });
    }
    EXPECT_EQ(cell, p.size());
  }
}

TEST(OverlappingAmr, LayoutIsWhatTheFormatAsksFor)
{
  const std::string path = shared_file("layout.hdf");
  write_overlapping_amr(path, 0.25, kOrigin, two_levels(), MPI_COMM_WORLD);
  const Hdf5File file = Hdf5File::open(path, MPI_COMM_WORLD);
  EXPECT_EQ(file.read_text("/VTKHDF", "Type"), "OverlappingAMR");
  EXPECT_EQ(file.read_text("/VTKHDF", "GridDescription"), "XYZ");
  EXPECT_EQ(file.read_ints("/VTKHDF", "Version"), (std::vector<std::int64_t>{1, 0}));
  EXPECT_EQ(file.read_doubles("/VTKHDF", "Origin"), (std::vector<double>{-1.0, 0.5, 2.0}));
  EXPECT_EQ(file.read_doubles("/VTKHDF/Level1", "Spacing"), (std::vector<double>{0.25, 0.25, 0.25}));
  EXPECT_EQ(file.read<int>("/VTKHDF/Level1/AMRBox"), (std::vector<int>{4, 7, 2, 5, 2, 5, 8, 11, 2, 7, 2, 3}));
  EXPECT_EQ(file.shape("/VTKHDF/Level0/CellData/velocity_cm_s"), (common::Shape{144, 3}));
  EXPECT_TRUE(file.exists("/VTKHDF/Level0/PointData"));
  EXPECT_TRUE(file.exists("/VTKHDF/Level1/FieldData"));
  EXPECT_FALSE(file.exists("/VTKHDF/Level2"));
}

/// Rank r holds r + 2 points in a row, joined by lines, and one point alone.
StructurePicture row_of_points()
{
  StructurePicture fibres;
  const int n = mpi_rank() + 2;
  for (int i = 0; i <= n; ++i) {
    fibres.points.push_back({0.5 * i, 1.0 * mpi_rank(), i == n ? 9.0 : 0.0});
    fibres.group.push_back(i == n ? 0 : 1 + mpi_rank());
  }
  for (int i = 0; i + 1 < n; ++i) {
    fibres.elements.add(std::array{i, i + 1});
    fibres.strain.push_back(0.125F * static_cast<float>(i + 1));
  }
  return fibres;
}

TEST(Fibres, LinesAndLonePointsOfEveryRankReadBack)
{
  const std::string path = shared_file("fibres.hdf");
  write_structure(path, 0.5, row_of_points(), {"wall", "leaflet 1", "leaflet 2"}, MPI_COMM_WORLD);
  const Hdf5File file = Hdf5File::open(path, MPI_COMM_WORLD);
  EXPECT_EQ(file.read_text("/", "group_names"), "wall\nleaflet 1\nleaflet 2");
  EXPECT_EQ(file.read_doubles("/", "time_s"), std::vector<double>{0.5});

  const auto points = file.read<std::int64_t>("/VTKHDF/NumberOfPoints");
  const auto cells = file.read<std::int64_t>("/VTKHDF/NumberOfCells");
  const auto ids = file.read<std::int64_t>("/VTKHDF/NumberOfConnectivityIds");
  const auto x = file.read<float>("/VTKHDF/Points");
  const auto joined = file.read<std::int64_t>("/VTKHDF/Connectivity");
  const auto offsets = file.read<std::int64_t>("/VTKHDF/Offsets");
  const auto types = file.read<std::uint8_t>("/VTKHDF/Types");
  const auto group = file.read<int>("/VTKHDF/PointData/group");
  const auto strain = file.read<float>("/VTKHDF/CellData/strain");
  ASSERT_EQ(points.size(), static_cast<std::size_t>(mpi_size()));
  std::size_t point = 0, cell = 0, id = 0, offset = 0;
  for (std::size_t r = 0; r < points.size(); ++r) {
    const std::size_t n = r + 2;
    ASSERT_EQ(points[r], static_cast<std::int64_t>(n + 1));
    ASSERT_EQ(cells[r], static_cast<std::int64_t>(n));
    ASSERT_EQ(ids[r], static_cast<std::int64_t>(2 * (n - 1) + 1));
    for (std::size_t c = 0; c + 1 < n; ++c) {
      EXPECT_EQ(types[cell + c], 3);
      EXPECT_EQ(offsets[offset + c], static_cast<std::int64_t>(2 * c));
      EXPECT_EQ(joined[id + 2 * c], static_cast<std::int64_t>(c));
      EXPECT_EQ(joined[id + 2 * c + 1], static_cast<std::int64_t>(c + 1));
      EXPECT_EQ(strain[cell + c], 0.125F * static_cast<float>(c + 1));
    }
    EXPECT_EQ(types[cell + n - 1], 1);
    EXPECT_EQ(x[3 * (point + n) + 2], 9.0F);
    EXPECT_EQ(x[3 * point + 1], static_cast<float>(r));
    EXPECT_EQ(group[point], static_cast<int>(1 + r));
    EXPECT_EQ(offsets[offset + n], ids[r]);
    point += n + 1, cell += n, id += 2 * n - 1, offset += n + 1;
  }
  EXPECT_EQ(offset, offsets.size());
}

TEST(Fibres, LineToAPointThatIsNotThereIsRefusedOnEveryRank)
{
  StructurePicture fibres = row_of_points();
  if (mpi_rank() == 0) fibres.elements.nodes[1] = 99;
  EXPECT_THROW(write_structure(shared_file("bad.hdf"), 0.0, fibres, {}, MPI_COMM_WORLD), IoError);
}

}  // namespace
}  // namespace valsalva::ib3d
