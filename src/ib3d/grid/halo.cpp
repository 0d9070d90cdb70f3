#include "ib3d/grid/halo.hpp"

#include <algorithm>
#include <map>

namespace valsalva::ib3d {

namespace {

template <class T>
MPI_Datatype mpi_type();
template <>
MPI_Datatype mpi_type<double>()
{
  return MPI_DOUBLE;
}
template <>
MPI_Datatype mpi_type<float>()
{
  return MPI_FLOAT;
}

IndexBox owned_box(const Level& level, const IndexBox& cells, Centering c)
{
  return c == Centering::cell ? cells : owned_faces(level, cells, static_cast<int>(c));
}

IndexBox ghosted_box(const IndexBox& cells, Centering c, int ghosts)
{
  return c == Centering::cell ? cells.grown(ghosts) : faces_of(cells.grown(ghosts), static_cast<int>(c));
}

template <class T, class F>
void for_each_row_of_copy(const IndexBox& region, F&& f)
{
  for_each_row(region,
               [&](int j, int k) { f(region.lo[0], j, k, static_cast<std::ptrdiff_t>(region.size(0))); });
}

}  // namespace

Halo::Halo(const Level& level, std::vector<Centering> centerings, int ghosts) : comm_(level.comm)
{
  int rank = 0;
  MPI_Comm_rank(comm_, &rank);
  std::vector<int> local_number(level.patches.size(), -1);
  for (int p = 0; p < level.local_count(); ++p)
    local_number[static_cast<std::size_t>(level.local[static_cast<std::size_t>(p)])] = p;

  Int3 reach{};
  for (int d = 0; d < 3; ++d) reach[static_cast<std::size_t>(d)] = level.domain.periodic(d) ? 1 : 0;
  std::map<int, Link> links;
  for (std::size_t g = 0; g < level.patches.size(); ++g)
    for (std::size_t o = 0; o < level.patches.size(); ++o) {
      const Patch& ghost = level.patches[g];
      const Patch& owner = level.patches[o];
      if (ghost.owner != rank && owner.owner != rank) continue;
      for_each_index(
          {{-reach[0], -reach[1], -reach[2]}, {reach[0] + 1, reach[1] + 1, reach[2] + 1}},
          [&](int sx, int sy, int sz) {
            if (g == o && sx == 0 && sy == 0 && sz == 0) return;
            const Int3 shift{sx * level.box.size(0), sy * level.box.size(1), sz * level.box.size(2)};
            for (std::size_t s = 0; s < centerings.size(); ++s) {
              const IndexBox there = intersect(owned_box(level, owner.box, centerings[s]).shifted(shift),
                                               ghosted_box(ghost.box, centerings[s], ghosts));
              if (there.empty()) continue;
              const Copy copy{static_cast<int>(s), local_number[o], local_number[g],
                              there.shifted({-shift[0], -shift[1], -shift[2]}), shift};
              if (ghost.owner == owner.owner) {
                on_rank_.push_back(copy);
                continue;
              }
              const bool receiving = ghost.owner == rank;
              Link& link = links[receiving ? owner.owner : ghost.owner];
              (receiving ? link.to_ghosts_here : link.to_ghosts_there).push_back(copy);
              (receiving ? link.receive_size : link.send_size) += static_cast<std::size_t>(there.volume());
            }
          });
    }
  for (auto& [other, link] : links) {
    link.rank = other;
    links_.push_back(std::move(link));
  }
}

template <class T, class At>
void Halo::fill_arrays(At&& at) const
{
  std::vector<std::vector<T>> out(links_.size()), in(links_.size());
  std::vector<MPI_Request> requests(2 * links_.size());
  for (std::size_t l = 0; l < links_.size(); ++l) {
    const Link& link = links_[l];
    in[l].resize(link.receive_size);
    MPI_Irecv(in[l].data(), static_cast<int>(link.receive_size), mpi_type<T>(), link.rank, 0, comm_,
              &requests[2 * l]);
    out[l].resize(link.send_size);
    T* next = out[l].data();
    for (const Copy& c : link.to_ghosts_there)
      for_each_row_of_copy<T>(c.region, [&](int i, int j, int k, std::ptrdiff_t n) {
        next = std::copy_n(at(c.owner_patch, c.slot).at(i, j, k), n, next);
      });
    MPI_Isend(out[l].data(), static_cast<int>(link.send_size), mpi_type<T>(), link.rank, 0, comm_,
              &requests[2 * l + 1]);
  }
  for (const Copy& c : on_rank_)
    for_each_row_of_copy<T>(c.region, [&](int i, int j, int k, std::ptrdiff_t n) {
      std::copy_n(at(c.owner_patch, c.slot).at(i, j, k), n,
                  at(c.ghost_patch, c.slot).at(i + c.shift[0], j + c.shift[1], k + c.shift[2]));
    });
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  for (std::size_t l = 0; l < links_.size(); ++l) {
    const T* next = in[l].data();
    for (const Copy& c : links_[l].to_ghosts_here)
      for_each_row_of_copy<T>(c.region, [&](int i, int j, int k, std::ptrdiff_t n) {
        std::copy_n(next, n, at(c.ghost_patch, c.slot).at(i + c.shift[0], j + c.shift[1], k + c.shift[2]));
        next += n;
      });
  }
}

template <class T>
void Halo::fill(CellField<T>& field) const
{
  fill_arrays<T>([&](int patch, int) -> Array3<T>& { return field[patch]; });
}
template void Halo::fill(CellField<double>&) const;
template void Halo::fill(CellField<float>&) const;

void Halo::fill(MacField& field) const
{
  fill_arrays<double>([&](int patch, int slot) -> Array3<double>& { return field(patch, slot); });
}

void Halo::accumulate(MacField& field) const
{
  std::vector<std::vector<double>> out(links_.size()), in(links_.size());
  std::vector<MPI_Request> requests(2 * links_.size());
  for (std::size_t l = 0; l < links_.size(); ++l) {
    const Link& link = links_[l];
    in[l].resize(link.send_size);
    MPI_Irecv(in[l].data(), static_cast<int>(link.send_size), MPI_DOUBLE, link.rank, 1, comm_,
              &requests[2 * l]);
    out[l].resize(link.receive_size);
    double* next = out[l].data();
    for (const Copy& c : link.to_ghosts_here)
      for_each_row_of_copy<double>(c.region, [&](int i, int j, int k, std::ptrdiff_t n) {
        next = std::copy_n(field(c.ghost_patch, c.slot).at(i + c.shift[0], j + c.shift[1], k + c.shift[2]), n,
                           next);
      });
    MPI_Isend(out[l].data(), static_cast<int>(link.receive_size), MPI_DOUBLE, link.rank, 1, comm_,
              &requests[2 * l + 1]);
  }
  const auto add = [&](const Copy& c, int i, int j, int k, std::ptrdiff_t n, const double* from) {
    double* to = field(c.owner_patch, c.slot).at(i, j, k);
    for (std::ptrdiff_t m = 0; m < n; ++m) to[m] += from[m];
  };
  for (const Copy& c : on_rank_)
    for_each_row_of_copy<double>(c.region, [&](int i, int j, int k, std::ptrdiff_t n) {
      add(c, i, j, k, n, field(c.ghost_patch, c.slot).at(i + c.shift[0], j + c.shift[1], k + c.shift[2]));
    });
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  for (std::size_t l = 0; l < links_.size(); ++l) {
    const double* next = in[l].data();
    for (const Copy& c : links_[l].to_ghosts_there)
      for_each_row_of_copy<double>(c.region, [&](int i, int j, int k, std::ptrdiff_t n) {
        add(c, i, j, k, n, next);
        next += n;
      });
  }
}

}  // namespace valsalva::ib3d
