// A fixed list of copies between arrays of patches, on one rank or across ranks: the engine of every exchange
// on the grid (halos, transfers between levels).
//   forward    to[region + shift]  = from[region]
//   transpose  from[region] += to[region + shift]      the exact transpose
// Both are collective. The order of the copies is fixed, so results do not depend on message timing.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <map>
#include <vector>

#include "ib3d/grid/fields.hpp"
#include "ib3d/grid/messages.hpp"

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

/// The values `region` of patch `from` belong at region + shift of patch `to`, in the arrays of this centring.
struct Copy {
  Centring centring;
  int from, to;  ///< local numbers, -1 where the patch is on another rank
  IndexBox region;
  Int3 shift;
};

class CopyPlan {
 public:
  explicit CopyPlan(MPI_Comm comm) : comm_(comm) { MPI_Comm_rank(comm_, &rank_); }

  /// Registers the copy of what `source`, indices of patch `from`, and `target`, indices of patch `to`, have in common.
  /// Every rank registers the same copies in the same order, or at least those it takes part in.
  void add(const Patch& from, const Patch& to, const Int3& shift, Centring centring, const IndexBox& source,
           const IndexBox& target)
  {
    const Copy copy{centring, from.local, to.local, intersect(source, target.shifted_back(shift)), shift};
    if (copy.region.empty() || (from.owner != rank_ && to.owner != rank_)) return;
    if (from.owner == to.owner) {
      on_rank_.push_back(copy);
      return;
    }
    const bool receiving = to.owner == rank_;
    Link& link = links_[receiving ? from.owner : to.owner];
    Bundle& bundle = receiving ? link.incoming : link.outgoing;
    bundle.copies.push_back(copy);
    bundle.size += static_cast<std::size_t>(copy.region.volume());
  }

  /// Registers what fills `wanted`, indices of a patch with the cells of `level`, from all patches of the level, or from
  /// the first of several that have a value. readable(cells) says which values a patch with these cells can give.
  template <class Readable>
  void add_sources(const Level& level, const Patch& to, Centring centring, const IndexBox& wanted,
                   Readable&& readable)
  {
    std::vector<IndexBox> rest{wanted};
    for_each_patch_image(level, [&](std::size_t n, const Int3& shift) {
      const IndexBox source = readable(level.patches[n].box);
      for (const IndexBox& box : rest) add(level.patches[n], to, shift, centring, source, box);
      rest = without(rest, source.shifted(shift));
    });
  }

  /// From a field to another (or to other places of the same one): both CellField<T> or both MacField.
  template <class Field>
  void forward(const Field& from, Field& to) const
  {
    run<typename Field::Value>(&Link::outgoing, &Link::incoming, Source{from}, Target{to},
                               copy_row<typename Field::Value>);
  }
  template <class Field>
  void transpose(Field& from, const Field& to) const
  {
    using T = typename Field::Value;
    run<T>(&Link::incoming, &Link::outgoing, Target{to}, Source{from},
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

  /// Address of index (i, j, k) of a copy in the patch it comes from, and of its image in the one it goes to.
  template <class Field>
  struct Source {
    Field& field;
    auto operator()(const Copy& c, int i, int j, int k) const
    {
      return field(c.from, c.centring).at(i, j, k);
    }
  };
  template <class Field>
  struct Target {
    Field& field;
    auto operator()(const Copy& c, int i, int j, int k) const
    {
      return field(c.to, c.centring).at(i + c.shift[0], j + c.shift[1], k + c.shift[2]);
    }
  };

  /// Takes rows at source(copy, i, j, k) and hands them to put at target(copy, i, j, k).
  template <class T, class From, class Into, class Put>
  void run(Bundle Link::*sends, Bundle Link::*receives, From&& source, Into&& target, Put&& put) const
  {
    Messages messages(comm_, Tag::patches);
    for (const auto& [other, link] : links_) {
      const Bundle &sending = link.*sends, &receiving = link.*receives;
      messages.receive(other, receiving.values<T>(), receiving.size);
      T* next = sending.values<T>();
      for (const Copy& c : sending.copies)
        for_each_row(c.region, [&](int j, int k) {
          copy_row<T>(next, source(c, c.region.lo[0], j, k), c.region.size(0));
          next += c.region.size(0);
        });
      messages.send(other, sending.values<T>(), sending.size);
    }
    for (const Copy& c : on_rank_)
      for_each_row(c.region, [&](int j, int k) {
        const int i = c.region.lo[0];
        put(target(c, i, j, k), source(c, i, j, k), c.region.size(0));
      });
    messages.wait();
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
