// The fields resampled to one uniform grid, as VTKHDF ImageData. The values stand at points, which are the
// centres of the cells: VTK up to 9.1 cannot read cell data of images.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "common/hdf5_file.hpp"
#include "ib3d/output/vtkhdf.hpp"

namespace valsalva::ib3d {
namespace {

using Size = std::size_t;

/// `repeat` cells of the image per cell and direction, or `merge` cells per cell of the image; one of them
/// is 1.
struct Ratio {
  int repeat = 1, merge = 1;
};

Ratio ratio_of(double spacing, double image_spacing)
{
  return {std::max(1, static_cast<int>(std::lround(spacing / image_spacing))),
          std::max(1, static_cast<int>(std::lround(image_spacing / spacing)))};
}

AmrBox in_image(AmrBox box, Ratio r)
{
  for (Size d = 0; d < 3; ++d) {
    box.lo[d] = box.lo[d] * r.repeat / r.merge;
    box.hi[d] = box.hi[d] * r.repeat / r.merge;
  }
  return box;
}

Int3 extent(const AmrBox& b)
{
  return {b.hi[0] - b.lo[0], b.hi[1] - b.lo[1], b.hi[2] - b.lo[2]};
}

/// Values of `box` (`width` per cell) on the cells of the image it covers.
std::vector<float> resample(const std::vector<float>& values, const AmrBox& box, Ratio r, Size width)
{
  const Int3 n = extent(box), m = extent(in_image(box, r));
  const auto at = [](const Int3& size, int i, int j, int k) {
    return static_cast<Size>(i) +
           static_cast<Size>(size[0]) *
               (static_cast<Size>(j) + static_cast<Size>(size[1]) * static_cast<Size>(k));
  };
  std::vector<float> out(at(m, 0, 0, m[2]) * width, 0.0F);
  const float weight = 1.0F / static_cast<float>(r.merge * r.merge * r.merge);
  const int fine[3] = {std::max(n[0], m[0]), std::max(n[1], m[1]), std::max(n[2], m[2])};
  for (int k = 0; k < fine[2]; ++k) {
    for (int j = 0; j < fine[1]; ++j) {
      for (int i = 0; i < fine[0]; ++i) {
        const Size from = at(n, i / r.repeat, j / r.repeat, k / r.repeat) * width;
        const Size to = at(m, i / r.merge, j / r.merge, k / r.merge) * width;
        for (Size c = 0; c < width; ++c) out[to + c] += weight * values[from + c];
      }
    }
  }
  return out;
}

/// Block after block, coarse levels first: what is finer overwrites what is coarser. Every rank makes as many
/// collective writes as the rank with the most blocks.
void write_level(Hdf5File& file, const AmrLevel& level, Ratio r, MPI_Comm comm)
{
  int rounds = static_cast<int>(level.local.size());
  MPI_Allreduce(MPI_IN_PLACE, &rounds, 1, MPI_INT, MPI_MAX, comm);
  for (Size b = 0; b < static_cast<Size>(rounds); ++b) {
    std::vector<Slab> vectors, scalars;
    std::vector<float> velocity, pressure;
    if (b < level.local.size()) {
      const AmrBlock& block = level.local[b];
      const AmrBox& box = level.boxes.at(static_cast<Size>(block.order));
      const AmrBox image = in_image(box, r);
      const Int3 n = extent(image);
      vectors.push_back({{image.lo[2], image.lo[1], image.lo[0], 0}, {n[2], n[1], n[0], 3}});
      scalars.push_back({{image.lo[2], image.lo[1], image.lo[0]}, {n[2], n[1], n[0]}});
      velocity = resample(block.velocity, box, r, 3);
      pressure = resample(block.pressure, box, r, 1);
    }
    file.write_more("/VTKHDF/PointData/velocity_cm_s", std::span<const Slab>(vectors),
                    std::span<const float>(velocity));
    file.write_more("/VTKHDF/PointData/pressure_mmHg", std::span<const Slab>(scalars),
                    std::span<const float>(pressure));
  }
}

}  // namespace

void write_image_data(const std::string& path, double time_s, const Vec3& origin,
                      const std::vector<AmrLevel>& levels, int at, MPI_Comm comm)
{
  const double h = levels.at(static_cast<Size>(at)).spacing;
  Int3 n{0, 0, 0};
  for (const AmrBox& b : levels[0].boxes) {
    const AmrBox image = in_image(b, ratio_of(levels[0].spacing, h));
    for (Size d = 0; d < 3; ++d) n[d] = std::max(n[d], image.hi[d]);
  }
  Hdf5File file = Hdf5File::create(path, comm);
  file.write_attribute("/", "time_s", std::span<const double>(&time_s, 1));
  file.create_group("/VTKHDF/PointData");
  file.write_attribute("/VTKHDF", "Version", std::array<std::int64_t, 2>{1, 0});
  file.write_attribute("/VTKHDF", "Type", std::string("ImageData"));
  file.write_attribute("/VTKHDF", "WholeExtent",
                       std::array<std::int64_t, 6>{0, n[0] - 1, 0, n[1] - 1, 0, n[2] - 1});
  const Vec3 first_centre = origin + Vec3{h / 2, h / 2, h / 2};
  file.write_attribute("/VTKHDF", "Origin", std::span<const double>(first_centre.c));
  file.write_attribute("/VTKHDF", "Spacing", std::array<double, 3>{h, h, h});
  file.write_attribute("/VTKHDF", "Direction", std::array<double, 9>{1, 0, 0, 0, 1, 0, 0, 0, 1});
  const std::span<const Slab> nothing_yet;
  file.write("/VTKHDF/PointData/velocity_cm_s", {n[2], n[1], n[0], 3}, nothing_yet, std::span<const float>());
  file.write("/VTKHDF/PointData/pressure_mmHg", {n[2], n[1], n[0]}, nothing_yet, std::span<const float>());
  for (const AmrLevel& level : levels) write_level(file, level, ratio_of(level.spacing, h), comm);
  file.close();
}

}  // namespace valsalva::ib3d
