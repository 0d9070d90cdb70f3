#include "ib3d/structure/fibres/fibre_network.hpp"

#include <utility>

namespace valsalva::ib3d {

namespace {

/// Local numbers: the owned nodes in the order given, then copies in the order of their first use.
class LocalNumbers {
 public:
  LocalNumbers(int node_count, std::span<const int> owned)
      : local_(static_cast<std::size_t>(node_count), -1), owned_(static_cast<int>(owned.size()))
  {
    for (int node : owned) number(node);
  }
  bool owns(int node) const
  {
    const int local = local_[static_cast<std::size_t>(node)];
    return local >= 0 && local < owned_;
  }
  int number(int node)
  {
    int& local = local_[static_cast<std::size_t>(node)];
    if (local < 0) {
      local = static_cast<int>(global_.size());
      global_.push_back(node);
    }
    return local;
  }
  std::vector<int> take_global() { return std::move(global_); }

 private:
  std::vector<int> local_, global_;
  int owned_;
};

}  // namespace

FibrePart restrict_to(const FibreNetwork& whole, std::span<const int> owned_nodes)
{
  LocalNumbers numbers(whole.node_count(), owned_nodes);
  FibrePart part;
  part.owned = static_cast<int>(owned_nodes.size());

  const Springs& springs = whole.springs;
  for (std::size_t n = 0; n < springs.a.size(); ++n) {
    if (!numbers.owns(springs.a[n]) && !numbers.owns(springs.b[n])) continue;
    const int a = numbers.number(springs.a[n]), b = numbers.number(springs.b[n]);
    part.network.springs.add(a, b, springs.stiffness[n], springs.rest_length[n],
                             springs.tension_only[n] != 0);
  }
  const Beams& beams = whole.beams;
  for (std::size_t n = 0; n < beams.x0.size(); ++n) {
    if (!numbers.owns(beams.x0[n]) && !numbers.owns(beams.x1[n]) && !numbers.owns(beams.x2[n])) continue;
    part.network.beams.add(
        {numbers.number(beams.x0[n]), numbers.number(beams.x1[n]), numbers.number(beams.x2[n])},
        beams.rigidity[n], beams.l1[n], beams.l2[n]);
  }
  const Tethers& tethers = whole.tethers;
  for (std::size_t n = 0; n < tethers.node.size(); ++n) {
    if (!numbers.owns(tethers.node[n])) continue;
    part.network.tethers.add(numbers.number(tethers.node[n]), tethers.stiffness[n], tethers.target[n]);
  }
  part.global = numbers.take_global();
  part.network.X.reserve(part.global.size());
  for (int node : part.global) part.network.X.push_back(whole.X[static_cast<std::size_t>(node)]);
  return part;
}

}  // namespace valsalva::ib3d
