// The ranks of a run: a thin value over MPI_Comm with the few reductions that decisions need. Sums run in
// rank order on every rank, so that the result is the same bit for bit on all ranks and in every repetition.
// Works in programs that never call MPI_Init: there is one rank then.
#pragma once

#include <mpi.h>

#include <functional>
#include <limits>
#include <numeric>
#include <string>
#include <type_traits>
#include <vector>

#include "common/error.hpp"

namespace valsalva::common {

/// MPI_Init for everything that may open files.
void start_mpi(int* argc = nullptr, char*** argv = nullptr);

/// The lists of all ranks one after the other, on every rank; T is copied byte by byte. Collective.
template <class T>
std::vector<T> gather_lists(const T* mine, int count, MPI_Comm comm)
{
  static_assert(std::is_trivially_copyable_v<T>);
  int ranks = 1, bytes = count * static_cast<int>(sizeof(T));
  MPI_Comm_size(comm, &ranks);
  std::vector<int> sizes(static_cast<std::size_t>(ranks)), starts(sizes.size(), 0);
  MPI_Allgather(&bytes, 1, MPI_INT, sizes.data(), 1, MPI_INT, comm);
  std::exclusive_scan(sizes.begin(), sizes.end(), starts.begin(), 0);
  std::vector<T> all(static_cast<std::size_t>(starts.back() + sizes.back()) / sizeof(T));
  MPI_Allgatherv(mine, bytes, MPI_BYTE, all.data(), sizes.data(), starts.data(), MPI_BYTE, comm);
  return all;
}

class Communicator {
 public:
  explicit Communicator(MPI_Comm comm) : comm_(comm)
  {
    int running = 0, ended = 0;
    MPI_Initialized(&running);
    MPI_Finalized(&ended);
    if (!running || ended) return;
    MPI_Comm_rank(comm_, &rank_);
    MPI_Comm_size(comm_, &size_);
  }

  int rank() const { return rank_; }
  int size() const { return size_; }
  bool is_rank_0() const { return rank_ == 0; }
  MPI_Comm raw() const { return comm_; }

  /// Sum over ranks in rank order. Collective.
  double sum(double x) const
  {
    double total = 0.0;
    for (double part : gather(x)) total += part;
    return total;
  }
  /// NaN if it is NaN on one rank. Collective.
  double max(double x) const
  {
    double largest[2] = {x != x ? 1.0 : 0.0, x != x ? 0.0 : x};  // MPI_MAX may lose a NaN
    if (size_ > 1) MPI_Allreduce(MPI_IN_PLACE, largest, 2, MPI_DOUBLE, MPI_MAX, comm_);
    return largest[0] > 0.0 ? std::numeric_limits<double>::quiet_NaN() : largest[1];
  }
  /// NaN if it is NaN on one rank. Collective.
  double min(double x) const { return -max(-x); }
  /// True on all ranks if true on one. Collective.
  bool any(bool on) const { return max(on ? 1.0 : 0.0) > 0.5; }
  /// One number per rank, on all ranks. Collective.
  std::vector<double> gather(double x) const
  {
    std::vector<double> all(static_cast<std::size_t>(size_), x);
    if (size_ > 1) MPI_Allgather(&x, 1, MPI_DOUBLE, all.data(), 1, MPI_DOUBLE, comm_);
    return all;
  }
  /// Rank 0's number, on all ranks. Collective.
  double from_rank_0(double x) const
  {
    if (size_ > 1) MPI_Bcast(&x, 1, MPI_DOUBLE, 0, comm_);
    return x;
  }
  /// Collective.
  void barrier() const
  {
    if (size_ > 1) MPI_Barrier(comm_);
  }

 private:
  MPI_Comm comm_;
  int rank_ = 0;
  int size_ = 1;
};

/// Runs `work` on rank 0 only. What it throws there all ranks throw, so that none waits for rank 0 inside the
/// next collective call; only rank 0's has a message. Collective.
void on_rank_0(const Communicator& comm, const std::function<void()>& work);

/// The same; `values`, of the same length on all ranks, are then rank 0's. One broadcast. Collective.
void on_rank_0(const Communicator& comm, const std::function<void()>& work, std::vector<double>& values);

}  // namespace valsalva::common

namespace valsalva {
using common::Communicator;
}  // namespace valsalva
