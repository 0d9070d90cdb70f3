// The datasets of an Hdf5File: written whole or by each rank's slabs, and read.
#include <utility>

#include "common/error.hpp"
#include "common/hdf5_file.hpp"
#include "common/hdf5_id.hpp"

namespace valsalva::common {
namespace {

std::vector<hsize_t> sizes(const Shape& shape)
{
  return {shape.begin(), shape.end()};
}

std::int64_t product(const Shape& shape)
{
  std::int64_t n = 1;
  for (std::int64_t extent : shape) n *= extent;
  return n;
}

std::int64_t value_count(std::span<const Slab> slabs)
{
  std::int64_t n = 0;
  for (const Slab& s : slabs) n += product(s.count);
  return n;
}

bool select(hid_t space, std::span<const Slab> slabs)
{
  bool done = H5Sselect_none(space) >= 0;
  for (const Slab& s : slabs) {
    if (product(s.count) == 0) continue;
    done = done && H5Sselect_hyperslab(space, H5S_SELECT_OR, sizes(s.start).data(), nullptr,
                                       sizes(s.count).data(), nullptr) >= 0;
  }
  return done && H5Sselect_valid(space) > 0 && H5Sget_select_npoints(space) == value_count(slabs);
}

hid_t collective_transfer(MPI_Comm comm)
{
  const hid_t list = H5Pcreate(H5P_DATASET_XFER);
  if (comm != MPI_COMM_NULL) H5Pset_dxpl_mpio(list, H5FD_MPIO_COLLECTIVE);
  return list;
}

/// All of one dataset on a rank: what rank 0 writes of replicated values.
std::vector<Slab> whole(const Shape& shape)
{
  return {Slab{Shape(shape.size(), 0), shape}};
}

Shape extent_of(hid_t set)
{
  const Id space(H5Dget_space(set), H5Sclose);
  std::vector<hsize_t> extent(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
  H5Sget_simple_extent_dims(space, extent.data(), nullptr);
  return {extent.begin(), extent.end()};
}

bool fits(const Shape& shape, std::span<const Slab> slabs)
{
  for (const Slab& s : slabs) {
    if (s.start.size() != shape.size() || s.count.size() != shape.size()) return false;
    for (std::size_t d = 0; d < shape.size(); ++d) {
      if (s.start[d] < 0 || s.count[d] < 0 || s.start[d] + s.count[d] > shape[d]) return false;
    }
  }
  return true;
}

/// Moves the slabs between memory and file with `move(memory space, file space, transfer list)`.
template <class Move>
bool transfer(hid_t set, std::span<const Slab> slabs, MPI_Comm comm, Move move)
{
  if (product(extent_of(set)) == 0) return true;  // HDF5 refuses to move nothing collectively
  const hsize_t n = static_cast<hsize_t>(value_count(slabs));
  const Id file_space(H5Dget_space(set), H5Sclose);
  const Id memory_space(H5Screate_simple(1, &n, nullptr), H5Sclose);
  const Id list(collective_transfer(comm), H5Pclose);
  return select(file_space, slabs) && move(memory_space, file_space, list) >= 0;
}

}  // namespace

Shape Hdf5File::shape(const std::string& dataset) const
{
  const Id set(H5Dopen2(file_, dataset.c_str(), H5P_DEFAULT), H5Dclose);
  require(set.ok(), "dataset " + dataset + " could not be opened");
  return extent_of(set);
}

template <class T>
void Hdf5File::write(const std::string& name, const Shape& shape, std::span<const T> values)
{
  if (rank_ == 0) return write(name, shape, std::span<const Slab>(whole(shape)), values);
  write(name, shape, std::span<const Slab>(), std::span<const T>());
}

template <class T>
void Hdf5File::write(const std::string& name, const Shape& shape, std::span<const Slab> slabs,
                     std::span<const T> values)
{
  {
    const Id space(H5Screate_simple(static_cast<int>(shape.size()), sizes(shape).data(), nullptr), H5Sclose);
    const Id links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
    H5Pset_create_intermediate_group(links, 1);
    const Id set(H5Dcreate2(file_, name.c_str(), hdf5_type<T>(), space, links, H5P_DEFAULT, H5P_DEFAULT),
                 H5Dclose);
    require(set.ok(), "dataset " + name + " could not be created");
  }
  write_more(name, slabs, values);
}

template <class T>
void Hdf5File::write_more(const std::string& name, std::span<const Slab> slabs, std::span<const T> values)
{
  const Id set(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
  require(set.ok(), "dataset " + name + " could not be opened");
  require(fits(extent_of(set), slabs), "slabs outside dataset " + name);
  require(value_count(slabs) == static_cast<std::int64_t>(values.size()),
          "dataset " + name + " was given more or fewer values than its slabs hold");
  const bool done = transfer(set, slabs, comm_, [&](hid_t memory, hid_t in_file, hid_t list) {
    return H5Dwrite(set, hdf5_type<T>(), memory, in_file, list, values.data());
  });
  require(done, "dataset " + name + " could not be written");
}

template <class T>
std::vector<T> Hdf5File::read(const std::string& dataset) const
{
  return read<T>(dataset, std::span<const Slab>(whole(shape(dataset))));
}

template <class T>
std::vector<T> Hdf5File::read(const std::string& dataset, std::span<const Slab> slabs) const
{
  const Id set(H5Dopen2(file_, dataset.c_str(), H5P_DEFAULT), H5Dclose);
  require(set.ok(), "dataset " + dataset + " could not be opened");
  require(fits(extent_of(set), slabs), "slabs outside dataset " + dataset);
  std::vector<T> values(static_cast<std::size_t>(value_count(slabs)));
  const bool done = transfer(set, slabs, comm_, [&](hid_t memory, hid_t in_file, hid_t list) {
    return H5Dread(set, hdf5_type<T>(), memory, in_file, list, values.data());
  });
  require(done, "dataset " + dataset + " could not be read");
  return values;
}

#define VALSALVA_HDF5_TYPE(T)                                                                        \
  template void Hdf5File::write(const std::string&, const Shape&, std::span<const T>);               \
  template void Hdf5File::write(const std::string&, const Shape&, std::span<const Slab>,             \
                                std::span<const T>);                                                 \
  template void Hdf5File::write_more(const std::string&, std::span<const Slab>, std::span<const T>); \
  template std::vector<T> Hdf5File::read(const std::string&) const;                                  \
  template std::vector<T> Hdf5File::read(const std::string&, std::span<const Slab>) const;
VALSALVA_HDF5_TYPE(std::uint8_t)
VALSALVA_HDF5_TYPE(int)
VALSALVA_HDF5_TYPE(std::int64_t)
VALSALVA_HDF5_TYPE(float)
VALSALVA_HDF5_TYPE(double)
#undef VALSALVA_HDF5_TYPE

}  // namespace valsalva::common
