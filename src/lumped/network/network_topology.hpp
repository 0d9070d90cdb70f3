// Who is joined to whom: nodes numbered in order of first mention, and the check that every pressure can be
// found. A network is solvable if every node has exactly one pressure in every position of its valves: at
// most one element fixes it, and at least one that is always there determines it (windkessel, chamber,
// pressure_source, the compliance of a vessel).
#pragma once

#include <string>
#include <vector>

#include "lumped/network/element.hpp"
#include "lumped/network/network_spec.hpp"

namespace valsalva::lumped {

/// Node numbers are indices of node_names.
struct NetworkTopology {
  std::vector<std::string> node_names;
  std::vector<std::vector<int>> element_nodes;  ///< per element, in the order of its type's terminals
  std::vector<int> port_nodes;
};

/// Of a completed spec. CaseError if a port is not a node; the message lists the nodes.
NetworkTopology number_nodes(const NetworkSpec& spec);

/// How an element is joined: node and role per terminal.
struct Joined {
  std::string element;
  std::vector<int> nodes;
  std::vector<NodeRole> roles;
};

/// CaseError with one problem per node whose pressure nothing, or more than one element, settles.
void check_solvable(const NetworkTopology& topology, const std::vector<Joined>& elements);

}  // namespace valsalva::lumped
