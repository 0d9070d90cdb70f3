// The fields as VTKHDF OverlappingAMR.
#include <algorithm>
#include <cstdint>
#include <span>

#include "common/hdf5_file.hpp"
#include "ib3d/output/vtkhdf.hpp"

namespace valsalva::ib3d {
namespace {

void write_boxes(Hdf5File& file, const std::string& group, const std::vector<IndexBox>& boxes)
{
  std::vector<int> bounds;
  for (const IndexBox& b : boxes) {
    for (std::size_t d = 0; d < 3; ++d) bounds.insert(bounds.end(), {b.lo[d], b.hi[d] - 1});
  }
  file.write(group + "/AMRBox", {std::ssize(boxes), 6}, std::span<const int>(bounds));
}

void write_cell_data(Hdf5File& file, const std::string& group, const AmrLevel& level)
{
  std::vector<std::int64_t> first{0};
  for (const IndexBox& b : level.boxes) first.push_back(first.back() + b.volume());

  std::vector<const AmrBlock*> blocks;
  for (const AmrBlock& b : level.local) blocks.push_back(&b);
  std::sort(blocks.begin(), blocks.end(), [](auto* a, auto* b) { return a->order < b->order; });

  std::vector<Slab> vectors, scalars;
  std::vector<float> velocity, pressure;
  for (const AmrBlock* b : blocks) {
    const auto order = static_cast<std::size_t>(b->order);
    const std::int64_t n = level.boxes.at(order).volume();
    vectors.push_back({{first[order], 0}, {n, 3}});
    scalars.push_back({{first[order]}, {n}});
    velocity.insert(velocity.end(), b->velocity.begin(), b->velocity.end());
    pressure.insert(pressure.end(), b->pressure.begin(), b->pressure.end());
  }
  const std::string data = group + "/CellData";
  file.write(data + "/velocity_cm_s", {first.back(), 3}, std::span<const Slab>(vectors),
             std::span<const float>(velocity));
  file.write(data + "/pressure_mmHg", {first.back()}, std::span<const Slab>(scalars),
             std::span<const float>(pressure));
}

}  // namespace

void write_overlapping_amr(const std::string& path, double time_s, const Vec3& origin,
                           const std::vector<AmrLevel>& levels, MPI_Comm comm)
{
  Hdf5File file = Hdf5File::create(path, comm);
  file.write_attribute("/", "time_s", std::span<const double>(&time_s, 1));
  file.create_group("/VTKHDF");
  file.write_attribute("/VTKHDF", "Version", std::array<std::int64_t, 2>{1, 0});
  file.write_attribute("/VTKHDF", "Type", std::string("OverlappingAMR"));
  file.write_attribute("/VTKHDF", "GridDescription", std::string("XYZ"));
  file.write_attribute("/VTKHDF", "Origin", std::span<const double>(origin.c));
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const std::string group = "/VTKHDF/Level" + std::to_string(l);
    const double h = levels[l].spacing;
    file.create_group(group);
    file.write_attribute(group, "Spacing", std::array<double, 3>{h, h, h});
    for (const char* name : {"/CellData", "/PointData", "/FieldData"}) file.create_group(group + name);
    write_boxes(file, group, levels[l].boxes);
    write_cell_data(file, group, levels[l]);
  }
  file.close();
}

}  // namespace valsalva::ib3d
