// An HDF5 file: RAII over the C API (1.10, serial or with MPI-IO). No hdf5.h is needed to use it.
// It is created under the name path + ".part" and renamed by close(): a file with its final name is complete.
// A file dropped without close(), because an exception passes by, is removed.
// Datasets are written in one piece from every rank's share. A `Slab` is a box [start, start + count) of the
// dataset; a rank's data hold the values of its slabs in the order of the dataset (last index fastest).
// Every call on a file opened with a communicator is collective; either no rank throws or all do.
// Names are full paths such as "/VTKHDF/CellData/pressure_mmHg"; missing groups on the way are created.
// T is one of std::uint8_t, int (32 bit), std::int64_t, float, double.
#pragma once

#include <mpi.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace valsalva::common {

using Shape = std::vector<std::int64_t>;

/// A box of a dataset: as many entries in `start` and `count` as the dataset has dimensions.
struct Slab {
  Shape start, count;
};

class Hdf5File {
 public:
  /// A new file of this process alone, or, with a communicator, of all its ranks together.
  static Hdf5File create(const std::string& path);
  static Hdf5File create(const std::string& path, MPI_Comm comm);
  /// An existing file, to be read. IoError where there is none or it is not HDF5.
  static Hdf5File open(const std::string& path);
  static Hdf5File open(const std::string& path, MPI_Comm comm);

  Hdf5File(Hdf5File&& other) noexcept;
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;
  Hdf5File& operator=(Hdf5File&&) = delete;
  ~Hdf5File();

  /// Whether a file must outlive a power failure too.
  enum class Durable { no, yes };
  /// Completes the file and gives it its name; IoError if that fails. Nothing may be called afterwards.
  void close(Durable durable = Durable::no);

  void create_group(const std::string& name);
  /// Attributes of the group or dataset `object`, which exists. Same values on every rank.
  void write_attribute(const std::string& object, const std::string& name,
                       std::span<const std::int64_t> values);
  void write_attribute(const std::string& object, const std::string& name, std::span<const double> values);
  /// Scalar string of fixed length, ASCII, padded with nulls.
  void write_attribute(const std::string& object, const std::string& name, const std::string& text);

  /// A dataset of which every rank holds the same values; rank 0's are written.
  template <class T>
  void write(const std::string& name, const Shape& shape, std::span<const T> values);
  /// A dataset of which this rank holds `slabs` (disjoint, in the order of the dataset; none is allowed).
  template <class T>
  void write(const std::string& name, const Shape& shape, std::span<const Slab> slabs,
             std::span<const T> values);
  /// Writes further slabs of a dataset that exists. As above.
  template <class T>
  void write_more(const std::string& name, std::span<const Slab> slabs, std::span<const T> values);

  bool exists(const std::string& name) const;
  Shape shape(const std::string& dataset) const;
  /// The whole dataset, or this rank's slabs of it, converted to T; IoError where it is missing.
  template <class T>
  std::vector<T> read(const std::string& dataset) const;
  template <class T>
  std::vector<T> read(const std::string& dataset, std::span<const Slab> slabs) const;
  std::vector<std::int64_t> read_ints(const std::string& object, const std::string& attribute) const;
  std::vector<double> read_doubles(const std::string& object, const std::string& attribute) const;
  std::string read_text(const std::string& object, const std::string& attribute) const;

 private:
  enum class Mode { create, open };
  Hdf5File(const std::string& path, MPI_Comm comm, Mode mode);
  void require(bool done, const std::string& what) const;
  void abandon() noexcept;

  std::string path_;
  MPI_Comm comm_;  ///< MPI_COMM_NULL: serial
  int rank_ = 0;
  bool writing_ = false;  ///< and not complete yet
  std::int64_t file_ = -1;
};

}  // namespace valsalva::common

namespace valsalva {
using common::Hdf5File;
using common::Slab;
}  // namespace valsalva
