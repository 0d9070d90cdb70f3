// A checkpoint: named values in one HDF5 file that all ranks write together and from which a run continues.
// The same call stores a value while the file is written and sets it while the file is read, so that an owner
// of state lists its members once:
//     void save_or_restore(Checkpoint& c) { c("t_s", t_); c("flow_ml_s", flow_); }
// Doubles keep all their bits. A file has its final name only once it is complete and on the disk. Names may
// hold slashes ("fluid/p"). Every call is collective; IoError, on all ranks, where a value is missing.
#pragma once

#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "common/hdf5_file.hpp"

namespace valsalva::common {

class Checkpoint {
 public:
  /// `comm` MPI_COMM_NULL: this process alone.
  static Checkpoint create(const std::string& path, MPI_Comm comm);
  /// IoError if the file is not a checkpoint, incomplete, or of another version of the format.
  static Checkpoint open(const std::string& path, MPI_Comm comm);

  bool reading() const { return reading_; }
  const std::string& path() const { return path_; }

  /// Values that every rank holds alike; those of rank 0 are stored.
  void operator()(const std::string& name, double& x) { number(name, x); }
  void operator()(const std::string& name, int& n) { number(name, n); }
  void operator()(const std::string& name, std::int64_t& n) { number(name, n); }
  void operator()(const std::string& name, std::string& text);
  void operator()(const std::string& name, std::vector<int>& values);
  void operator()(const std::string& name, std::vector<double>& values);
  /// Rows of plain structs of doubles, such as Vec3.
  template <class Row>
  void operator()(const std::string& name, std::vector<Row>& rows);

  /// Values spread over the ranks, `total` in all. `shares` are this rank's, in the order of the file: ranges of
  /// one dimension, disjoint between the ranks when writing. Reading fills `values`.
  void spread(const std::string& name, std::int64_t total, const std::vector<Slab>& shares,
              std::vector<double>& values);

  /// Completes a file that was written.
  void close() { file_.close(Hdf5File::Durable::yes); }

 private:
  Checkpoint(Hdf5File file, std::string path, bool reading);
  template <class T>
  void number(const std::string& name, T& x);
  template <class T>
  void list(const std::string& name, std::vector<T>& values);

  Hdf5File file_;
  std::string path_;
  bool reading_;
};

template <class Row>
void Checkpoint::operator()(const std::string& name, std::vector<Row>& rows)
{
  static_assert(std::is_trivially_copyable_v<Row> && sizeof(Row) % sizeof(double) == 0);
  constexpr std::size_t width = sizeof(Row) / sizeof(double);
  std::vector<double> flat(rows.size() * width);
  if (!rows.empty()) std::memcpy(flat.data(), rows.data(), flat.size() * sizeof(double));
  (*this)(name, flat);
  rows.resize(flat.size() / width);
  if (!rows.empty()) std::memcpy(static_cast<void*>(rows.data()), flat.data(), rows.size() * sizeof(Row));
}

}  // namespace valsalva::common

namespace valsalva {
using common::Checkpoint;
}  // namespace valsalva
