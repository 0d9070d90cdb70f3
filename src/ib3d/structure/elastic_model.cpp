#include "ib3d/structure/elastic_model.hpp"

#include <algorithm>

namespace valsalva::ib3d {

Selection touching(const Elements& elements, int node_count, std::span<const int> owned)
{
  Selection s;
  s.number.assign(static_cast<std::size_t>(node_count), -1);
  const auto take = [&](int node) {
    int& number = s.number[static_cast<std::size_t>(node)];
    if (number >= 0) return;
    number = static_cast<int>(s.nodes.size());
    s.nodes.push_back(node);
  };
  for (const int node : owned) take(node);
  const auto is_owned = [&](int node) {
    const int number = s.number[static_cast<std::size_t>(node)];
    return number >= 0 && number < static_cast<int>(owned.size());
  };
  for (int e = 0; e < elements.count(); ++e) {
    const std::span<const int> nodes = elements[e];
    if (std::none_of(nodes.begin(), nodes.end(), is_owned)) continue;
    s.elements.push_back(e);
    for (const int node : nodes) take(node);
  }
  return s;
}

}  // namespace valsalva::ib3d
