#include "ib3d/interaction/node_distribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "common/comm.hpp"
#include "common/error.hpp"
#include "ib3d/grid/messages.hpp"
#include "ib3d/interaction/spread_interpolate.hpp"

namespace valsalva::ib3d {

namespace {

/// The cell under X, moved inside the domain if X lies on or slightly beyond a side.
Int3 cell_under(const Level& level, const Vec3& X)
{
  Int3 c{};
  for (std::size_t d = 0; d < 3; ++d) {
    const double at = std::floor(X[static_cast<int>(d)] / level.h);
    if (!(at >= level.box.lo[d] - 1 - kNodeDrift && at <= level.box.hi[d] + kNodeDrift))
      throw SolverError(
          fmt::format("a node of the structure is at ({:.4g}, {:.4g}, {:.4g}) cm, outside the domain; "
                      "use a smaller time.cfl or time.elastic_safety",
                      X[0], X[1], X[2]));
    c[d] = std::clamp(static_cast<int>(at), level.box.lo[d], level.box.hi[d] - 1);
  }
  return c;
}

}  // namespace

NodeDistribution::NodeDistribution(std::unique_ptr<const ElasticModel> whole, const Level& level)
    : whole_(std::move(whole)), level_(&level)
{
  distribute(whole_->start());
}

void NodeDistribution::distribute(const std::vector<Vec3>& X_global)
{
  const int rank = common::Communicator(level_->comm).rank();
  struct Home {
    int patch;
    long cell;
    int node;
    auto operator<=>(const Home&) const = default;
  };
  std::vector<int> owner(X_global.size());
  std::vector<Home> mine;
  for (std::size_t n = 0; n < X_global.size(); ++n) {
    const Int3 c = cell_under(*level_, X_global[n]);
    const Patch* patch = level_->patch_at(c);
    if (patch == nullptr)
      throw SolverError(
          fmt::format("node {} has left the finest level of the grid; use a larger grid.margin_cells", n));
    owner[n] = patch->owner;
    if (patch->owner == rank) {
      const long cell = c[0] + level_->box.size(0) * (c[1] + static_cast<long>(level_->box.size(1)) * c[2]);
      mine.push_back({patch->local, cell, static_cast<int>(n)});
    }
  }
  std::sort(mine.begin(), mine.end());

  std::vector<int> nodes;
  first_.assign(static_cast<std::size_t>(level_->local_count()) + 1, 0);
  for (const Home& home : mine) {
    nodes.push_back(home.node);
    ++first_[static_cast<std::size_t>(home.patch) + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  Selection selection = touching(whole_->elements(), whole_->node_count(), nodes);
  part_ = whole_->part(selection);
  global_ = std::move(selection.nodes);
  X_.clear();
  for (const int node : global_) X_.push_back(X_global[static_cast<std::size_t>(node)]);
  plan_copies(owner);
}

void NodeDistribution::plan_copies(const std::vector<int>& owner)
{
  const auto count = static_cast<std::size_t>(common::Communicator(level_->comm).size());
  std::vector<std::vector<int>> wanted(count), wanted_local(count);
  for (auto i = static_cast<std::size_t>(owned()); i < global_.size(); ++i) {
    const auto from = static_cast<std::size_t>(owner[static_cast<std::size_t>(global_[i])]);
    wanted[from].push_back(global_[i]);
    wanted_local[from].push_back(static_cast<int>(i));
  }
  local_number_.assign(owner.size(), -1);
  for (int i = 0; i < owned(); ++i)
    local_number_[static_cast<std::size_t>(global_[static_cast<std::size_t>(i)])] = i;

  std::vector<int> asked(count), sizes(count);
  for (std::size_t r = 0; r < count; ++r) sizes[r] = static_cast<int>(wanted[r].size());
  MPI_Alltoall(sizes.data(), 1, MPI_INT, asked.data(), 1, MPI_INT, level_->comm);
  sends_.clear();
  receives_.clear();
  Messages messages(level_->comm, Tag::wanted_nodes);
  std::vector<std::vector<int>> requested(count);
  for (std::size_t r = 0; r < count; ++r) {
    if (asked[r] > 0) {
      requested[r].resize(static_cast<std::size_t>(asked[r]));
      messages.receive(static_cast<int>(r), requested[r].data(), requested[r].size());
    }
    if (!wanted[r].empty()) {
      messages.send(static_cast<int>(r), wanted[r].data(), wanted[r].size());
      receives_.push_back({static_cast<int>(r), wanted_local[r]});
    }
  }
  messages.wait();
  for (std::size_t r = 0; r < count; ++r) {
    if (requested[r].empty()) continue;
    for (int& node : requested[r]) node = local_number_[static_cast<std::size_t>(node)];
    sends_.push_back({static_cast<int>(r), requested[r]});
  }
}

void NodeDistribution::fill_copies(std::vector<Vec3>& values) const
{
  Messages messages(level_->comm, Tag::copied_values);
  std::vector<std::vector<Vec3>> out(sends_.size()), in(receives_.size());
  for (std::size_t l = 0; l < receives_.size(); ++l) {
    in[l].resize(receives_[l].local_nodes.size());
    messages.receive(receives_[l].rank, in[l].data(), in[l].size());
  }
  for (std::size_t l = 0; l < sends_.size(); ++l) {
    for (int node : sends_[l].local_nodes) out[l].push_back(values[static_cast<std::size_t>(node)]);
    messages.send(sends_[l].rank, out[l].data(), out[l].size());
  }
  messages.wait();
  for (std::size_t l = 0; l < receives_.size(); ++l)
    for (std::size_t i = 0; i < in[l].size(); ++i)
      values[static_cast<std::size_t>(receives_[l].local_nodes[i])] = in[l][i];
}

std::vector<Vec3> NodeDistribution::gather(const std::vector<Vec3>& values) const
{
  const std::vector<int> nodes = common::gather_lists(global_.data(), owned(), level_->comm);
  const std::vector<Vec3> of_nodes = common::gather_lists(values.data(), owned(), level_->comm);
  std::vector<Vec3> all(whole_->start().size());
  for (std::size_t i = 0; i < nodes.size(); ++i) all[static_cast<std::size_t>(nodes[i])] = of_nodes[i];
  return all;
}

std::vector<Vec3> NodeDistribution::gather(const std::vector<Vec3>& values,
                                           const std::vector<int>& nodes) const
{
  std::vector<Vec3> found(nodes.size(), Vec3{0, 0, 0});
  for (std::size_t m = 0; m < nodes.size(); ++m)
    if (const int local = local_number_[static_cast<std::size_t>(nodes[m])]; local >= 0)
      found[m] = values[static_cast<std::size_t>(local)];
  MPI_Allreduce(MPI_IN_PLACE, found.data(), static_cast<int>(3 * found.size()), MPI_DOUBLE, MPI_SUM,
                level_->comm);
  return found;
}

double NodeDistribution::farthest_out(const std::vector<Vec3>& X) const
{
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double farthest = -kInfinity;
  for (int p = 0; p < level_->local_count(); ++p) {
    const IndexBox& box = level_->local_box(p);
    for (int n = first_[static_cast<std::size_t>(p)]; n < first_[static_cast<std::size_t>(p) + 1]; ++n)
      for (std::size_t d = 0; d < 3; ++d) {
        const double at = X[static_cast<std::size_t>(n)][static_cast<int>(d)] / level_->h;
        if (!std::isfinite(at)) return kInfinity;
        farthest = std::max({farthest, box.lo[d] - at, at - box.hi[d]});
      }
  }
  return farthest;
}

void NodeDistribution::move_to(const Level& level, const std::vector<Vec3>& X)
{
  level_ = &level;
  distribute(X);
}

void NodeDistribution::save_or_restore(Checkpoint& c)
{
  std::vector<Vec3> X = gather(X_);
  c("structure/X_distributed", X);
  if (X.size() != whole_->start().size())
    throw IoError(
        fmt::format("{}: {} nodes, but the case builds {}", c.path(), X.size(), whole_->node_count()));
  if (c.reading()) distribute(X);
}

void NodeDistribution::save_or_restore(Checkpoint& c, const std::string& name,
                                       std::vector<Vec3>& values) const
{
  std::vector<Vec3> all = c.reading() ? std::vector<Vec3>{} : gather(values);
  c(name, all);
  if (!c.reading()) return;
  values.clear();
  for (int node : global_) values.push_back(all.at(static_cast<std::size_t>(node)));
}

}  // namespace valsalva::ib3d
