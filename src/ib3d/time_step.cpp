#include "ib3d/time_step.hpp"

#include <cmath>

namespace valsalva::ib3d {

double ElasticBound::update(const NodeDistribution& nodes, const Interaction& interaction,
                            const std::vector<Vec3>& X, int sweeps)
{
  if (nodes.whole().node_count() == 0) return 0;
  if (!started_) {
    started_ = true;
    // Deterministic, rough, and the same whatever the number of ranks.
    v_.resize(X.size());
    for (std::size_t i = 0; i < v_.size(); ++i) {
      const int n = nodes.global()[i];
      v_[i] = {std::sin(1.3 * n), std::cos(2.1 * n), std::sin(3.7 * n + 1)};
    }
    sweeps += 20;
  }
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    nodes.fill_copies(v_);
    stiff_.assign(X.size(), Vec3{0, 0, 0});
    nodes.part().add_stiffness_times(X, v_, stiff_);
    interaction.spread(nodes.first(), X, stiff_, f_);
    interaction.fill_ghosts(f_);
    double sums[2] = {0, 0};
    for (int n = 0; n < nodes.owned(); ++n)
      sums[0] += dot(v_[static_cast<std::size_t>(n)], v_[static_cast<std::size_t>(n)]);
    interaction.interpolate(nodes.first(), X, f_, v_);
    for (int n = 0; n < nodes.owned(); ++n)
      sums[1] += dot(v_[static_cast<std::size_t>(n)], v_[static_cast<std::size_t>(n)]);
    MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_DOUBLE, MPI_SUM, comm_);
    if (sums[1] == 0) return omega_ = 0;
    omega_ = std::sqrt(std::sqrt(sums[1] / sums[0]) / density_);
    const double scale = 1 / std::sqrt(sums[1]);
    for (Vec3& v : v_) v = scale * v;
  }
  return omega_;
}

void ElasticBound::save_or_restore(Checkpoint& c, const NodeDistribution& nodes)
{
  c("structure/omega", omega_);
  int started = started_ ? 1 : 0;
  c("structure/eigenvector_started", started);
  started_ = started != 0;
  if (started_)
    nodes.save_or_restore(c, "structure/eigenvector", v_);
  else
    restart();
}

}  // namespace valsalva::ib3d
