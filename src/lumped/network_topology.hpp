// Who is joined to whom: nodes numbered in order of first mention, and the check that every pressure can be
// found. A network is solvable if every node has exactly one pressure in every position of its valves: at
// most one element fixes it, and at least one that is always there determines it (windkessel3, chamber,
// pressure_source).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lumped/element.hpp"
#include "lumped/network_spec.hpp"

namespace valsalva::lumped {

struct NetworkTopology {
  std::vector<std::string> node_names;
  std::vector<std::vector<int>> element_nodes;  ///< per element, in the order of its type's terminals
  std::vector<int> port_nodes;
};

/// Of a completed spec. CaseError if a port is not a node; the message lists the nodes.
NetworkTopology number_nodes(const NetworkSpec& spec);

/// CaseError with one problem per node whose pressure nothing, or more than one element, settles.
void check_solvable(const NetworkTopology& topology, const std::vector<std::unique_ptr<Element>>& elements);

}  // namespace valsalva::lumped
