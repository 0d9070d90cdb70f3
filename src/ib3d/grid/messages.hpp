// Messages between ranks that are under way at the same time: the one place of ib3d that sends from rank to rank. Buffers
// must stay where they are until `wait`. A tag keeps the messages of one kind of exchange from those of another.
#pragma once

#include <mpi.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace valsalva::ib3d {

enum class Tag {
  patches,        ///< values between patches, on one level or between two
  level_edges,    ///< pressures and fluxes at the edge of a refined level
  wanted_nodes,   ///< which nodes a rank wants copies of
  copied_values,  ///< the values of these nodes
};

class Messages {
 public:
  Messages(MPI_Comm comm, Tag tag) : comm_(comm), tag_(static_cast<int>(tag)) {}

  template <class T>
  void receive(int from, T* values, std::size_t count)
  {
    static_assert(std::is_trivially_copyable_v<T>);
    MPI_Irecv(values, static_cast<int>(count * sizeof(T)), MPI_BYTE, from, tag_, comm_,
              &requests_.emplace_back());
  }
  template <class T>
  void send(int to, const T* values, std::size_t count)
  {
    static_assert(std::is_trivially_copyable_v<T>);
    MPI_Isend(values, static_cast<int>(count * sizeof(T)), MPI_BYTE, to, tag_, comm_,
              &requests_.emplace_back());
  }
  /// Until all have arrived and all buffers are free again.
  void wait()
  {
    MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
    requests_.clear();
  }

 private:
  MPI_Comm comm_;
  int tag_;
  std::vector<MPI_Request> requests_;
};

}  // namespace valsalva::ib3d
