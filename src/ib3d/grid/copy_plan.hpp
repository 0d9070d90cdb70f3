// A fixed list of copies between arrays of patches, on one rank or across ranks: the engine of every exchange
// on the grid (halos, transfers between levels).
//   forward    to[region + shift]  = from[region]
//   transpose  from[region] += to[region + shift]      the exact transpose
// Both are collective. The order of the copies is fixed, so results do not depend on message timing.
#pragma once

#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <map>
#include <type_traits>
#include <vector>

#include "ib3d/grid/fields.hpp"

namespace valsalva::ib3d {

/// out[0..n) = in[0..n). Rows of ghosts are short: a call of memmove would take longer than the copy.
template <class T>
inline void copy_row(T* out, const T* in, std::ptrdiff_t n)
{
  switch (n) {
    case 1:
      std::memcpy(out, in, sizeof(T));
      return;
    case 2:
      std::memcpy(out, in, 2 * sizeof(T));
      return;
    case 3:
      std::memcpy(out, in, 3 * sizeof(T));
      return;
    case 4:
      std::memcpy(out, in, 4 * sizeof(T));
      return;
    default:
      std::copy_n(in, n, out);
  }
}

/// The values `region` of array `slot` of patch `from` belong at region + shift of array `slot` of patch `to`.
struct Copy {
  int slot;
  int from, to;  ///< local numbers, meaningful where the patch is on this rank
  IndexBox region;
  Int3 shift;
};

class CopyPlan {
 public:
  explicit CopyPlan(MPI_Comm comm) : comm_(comm) { MPI_Comm_rank(comm_, &rank_); }

  /// Registers a copy; every rank registers the same ones in the same order, or at least those it takes part in.
  void add(int from_owner, int to_owner, const Copy& copy)
  {
    if (copy.region.empty() || (from_owner != rank_ && to_owner != rank_)) return;
    if (from_owner == to_owner) {
      on_rank_.push_back(copy);
      return;
    }
    const bool receiving = to_owner == rank_;
    Link& link = links_[receiving ? from_owner : to_owner];
    Bundle& bundle = receiving ? link.incoming : link.outgoing;
    bundle.copies.push_back(copy);
    bundle.size += static_cast<std::size_t>(copy.region.volume());
  }

  /// from(patch, slot) and to(patch, slot) give the arrays (Array3<T>).
  template <class T, class From, class To>
  void forward(From&& from, To&& to) const
  {
    run<T>(
        &Link::outgoing, &Link::incoming,
        [&](const Copy& c, int i, int j, int k) { return from(c.from, c.slot).at(i, j, k); },
        [&](const Copy& c, int i, int j, int k) { return shifted(to(c.to, c.slot), c, i, j, k); },
        copy_row<T>);
  }
  template <class T, class From, class To>
  void transpose(From&& from, To&& to) const
  {
    run<T>(
        &Link::incoming, &Link::outgoing,
        [&](const Copy& c, int i, int j, int k) { return shifted(to(c.to, c.slot), c, i, j, k); },
        [&](const Copy& c, int i, int j, int k) { return from(c.from, c.slot).at(i, j, k); },
        [](T* out, const T* in, std::ptrdiff_t n) {
          for (std::ptrdiff_t m = 0; m < n; ++m) out[m] += in[m];
        });
  }

 private:
  struct Bundle {
    std::vector<Copy> copies;
    std::size_t size = 0;                    ///< values in all of them
    mutable std::vector<std::byte> message;  ///< kept from one exchange to the next
    template <class T>
    T* values() const
    {
      message.resize(std::max(message.size(), size * sizeof(T)));
      return reinterpret_cast<T*>(message.data());
    }
  };
  struct Link {
    Bundle outgoing, incoming;
  };

  template <class A>
  static auto shifted(A&& array, const Copy& c, int i, int j, int k)
  {
    return array.at(i + c.shift[0], j + c.shift[1], k + c.shift[2]);
  }

  /// Takes rows at source(copy, i, j, k) and hands them to put at target(copy, i, j, k).
  template <class T, class Source, class Target, class Put>
  void run(Bundle Link::*sends, Bundle Link::*receives, Source&& source, Target&& target, Put&& put) const
  {
    static_assert(std::is_same_v<T, double> || std::is_same_v<T, float>);
    const MPI_Datatype type = std::is_same_v<T, double> ? MPI_DOUBLE : MPI_FLOAT;
    std::vector<MPI_Request> requests(2 * links_.size());
    std::size_t l = 0;
    for (const auto& [other, link] : links_) {
      const Bundle &sending = link.*sends, &receiving = link.*receives;
      MPI_Irecv(receiving.values<T>(), static_cast<int>(receiving.size), type, other, 0, comm_,
                &requests[2 * l]);
      T* next = sending.values<T>();
      for (const Copy& c : sending.copies)
        for_each_row(c.region, [&](int j, int k) {
          copy_row<T>(next, source(c, c.region.lo[0], j, k), c.region.size(0));
          next += c.region.size(0);
        });
      MPI_Isend(sending.values<T>(), static_cast<int>(sending.size), type, other, 0, comm_,
                &requests[2 * l + 1]);
      ++l;
    }
    for (const Copy& c : on_rank_)
      for_each_row(c.region, [&](int j, int k) {
        const int i = c.region.lo[0];
        put(target(c, i, j, k), source(c, i, j, k), c.region.size(0));
      });
    MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
    for (const auto& [other, link] : links_) {
      const T* next = (link.*receives).template values<T>();
      for (const Copy& c : (link.*receives).copies)
        for_each_row(c.region, [&](int j, int k) {
          put(target(c, c.region.lo[0], j, k), next, c.region.size(0));
          next += c.region.size(0);
        });
    }
  }

  MPI_Comm comm_;
  int rank_ = 0;
  std::vector<Copy> on_rank_;
  std::map<int, Link> links_;
};

}  // namespace valsalva::ib3d
