#include "ib3d/interaction/markers.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "common/comm.hpp"
#include "ib3d/interaction/spread_interpolate.hpp"

namespace valsalva::ib3d {

namespace {

constexpr double kSameTime_s = 1e-9;

/// Back into the domain along its periodic directions.
void wrap(const Domain& domain, Vec3& X)
{
  for (int d = 0; d < 3; ++d)
    if (domain.periodic(d)) X[d] -= domain.size[d] * std::floor(X[d] / domain.size[d]);
}

bool inside(const Domain& domain, const Vec3& X)
{
  bool in = true;
  for (int d = 0; d < 3; ++d) in = in && X[d] >= 0 && X[d] <= domain.size[d];
  return in;  // false for what is not a number
}

/// Whether the finest box under the marker belongs to this rank; then the marker learns its level and patch.
bool take_in(const Hierarchy& grid, Marker& m)
{
  if (!inside(grid.domain(), m.X)) return false;
  for (m.level = grid.level_count() - 1; m.level >= 0; --m.level) {
    const Level& at = grid.level(m.level);
    Int3 cell{};
    for (std::size_t d = 0; d < 3; ++d)
      cell[d] = std::min(static_cast<int>(m.X[static_cast<int>(d)] / at.h), at.box.hi[d] - 1);
    if (const Patch* patch = at.patch_at(cell)) {
      m.patch = patch->local;
      return m.patch >= 0;
    }
  }
  return false;
}

}  // namespace

Markers::Markers(std::vector<MarkerSeed> seeds) : seeds_(std::move(seeds)), seedings_(seeds_.size(), 0) {}

std::vector<Marker> Markers::gather(MPI_Comm comm) const
{
  std::vector<Marker> all = common::gather_lists(markers_.data(), static_cast<int>(markers_.size()), comm);
  std::sort(all.begin(), all.end(), [](const Marker& a, const Marker& b) { return a.id < b.id; });
  return all;
}

void Markers::seed_due(const Hierarchy& grid, const CompositeMac& u, double t)
{
  const int out_before = next_id_;
  for (std::size_t g = 0; g < seeds_.size(); ++g) {
    const MarkerSeed& seed = seeds_[g];
    const double due = seed.start_s + seedings_[g] * seed.every_s;
    if (t < due - kSameTime_s || t > seed.end_s + kSameTime_s || (seed.every_s == 0 && seedings_[g] > 0))
      continue;
    // a step that is longer than the interval passes over the times in it
    const double passed = seed.every_s > 0 ? std::floor((t + kSameTime_s - seed.start_s) / seed.every_s) : 0;
    seedings_[g] = static_cast<int>(passed) + 1;
    for (const Vec3& X : seed.points) {
      Marker marker{X, {}, t, next_id_++, static_cast<int>(g), 0, 0};
      if (take_in(grid, marker)) markers_.push_back(marker);
    }
  }
  if (next_id_ == out_before) return;
  sort_by_patch(grid);
  X_.clear();
  for (const Marker& m : markers_) X_.push_back(m.X);
  interpolate(grid, u);
  for (std::size_t n = 0; n < markers_.size(); ++n)
    if (markers_[n].id >= out_before) markers_[n].U = U_[n];
}

void Markers::interpolate(const Hierarchy& grid, const CompositeMac& u)
{
  U_.resize(X_.size());
  for (int l = 0; l < grid.level_count(); ++l) {
    const auto ll = static_cast<std::size_t>(l);
    if (!first_.empty()) ib3d::interpolate(grid.level(l), first_[ll], X_, u[ll], U_);
  }
}

void Markers::advance(const Hierarchy& grid, const CompositeMac& u, double dt)
{
  if (!wanted()) return;
  X_.resize(markers_.size());
  for (std::size_t n = 0; n < X_.size(); ++n) X_[n] = markers_[n].X + dt * markers_[n].U;
  interpolate(grid, u);
  for (std::size_t n = 0; n < X_.size(); ++n) {
    Marker& m = markers_[n];
    m.X += 0.5 * dt * (m.U + U_[n]);
    m.U = U_[n];
  }
  settle(grid);
}

void Markers::settle(const Hierarchy& grid)
{
  if (!wanted()) return;
  const Communicator comm(grid.comm());
  std::vector<Marker> staying, leaving;
  for (Marker& m : markers_) {
    wrap(grid.domain(), m.X);
    (take_in(grid, m) ? staying : leaving).push_back(m);
  }
  for (Marker& m : common::gather_lists(leaving.data(), static_cast<int>(leaving.size()), comm.raw())) {
    if (!inside(grid.domain(), m.X)) ++lost_;
    if (take_in(grid, m)) staying.push_back(m);
  }
  markers_ = std::move(staying);
  sort_by_patch(grid);
}

void Markers::sort_by_patch(const Hierarchy& grid)
{
  const auto place = [](const Marker& m) { return std::tuple(m.level, m.patch, m.id); };
  const auto before = [&](const Marker& a, const Marker& b) { return place(a) < place(b); };
  if (!std::is_sorted(markers_.begin(), markers_.end(), before))
    std::sort(markers_.begin(), markers_.end(), before);
  first_.assign(static_cast<std::size_t>(grid.level_count()), {});
  int n = 0;
  for (int l = 0; l < grid.level_count(); ++l)
    for (int p = 0; p <= grid.level(l).local_count(); ++p) {
      first_[static_cast<std::size_t>(l)].push_back(n);
      while (n < static_cast<int>(markers_.size()) && markers_[static_cast<std::size_t>(n)].level == l &&
             markers_[static_cast<std::size_t>(n)].patch == p)
        ++n;
    }
}

void Markers::save_or_restore(Checkpoint& c, const Hierarchy& grid)
{
  if (!wanted()) return;
  std::vector<Marker> all;
  if (!c.reading()) all = gather(grid.comm());
  std::vector<Vec3> X, U;
  std::vector<double> seeded_s;
  std::vector<int> id, group;
  for (const Marker& m : all) {
    X.push_back(m.X);
    U.push_back(m.U);
    seeded_s.push_back(m.seeded_s);
    id.push_back(m.id);
    group.push_back(m.group);
  }
  c("markers/X", X);
  c("markers/U", U);
  c("markers/seeded_s", seeded_s);
  c("markers/id", id);
  c("markers/group", group);
  c("markers/seedings", seedings_);
  c("markers/next_id", next_id_);
  c("markers/lost", lost_);
  if (!c.reading()) return;
  markers_.clear();
  const bool first_rank = Communicator(grid.comm()).is_rank_0();
  for (std::size_t n = 0; first_rank && n < X.size(); ++n)
    markers_.push_back({X[n], U[n], seeded_s[n], id[n], group[n], 0, 0});
  settle(grid);
}

}  // namespace valsalva::ib3d
