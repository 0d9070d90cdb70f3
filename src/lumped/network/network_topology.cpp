#include "lumped/network/network_topology.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "common/nearest_name.hpp"
#include "lumped/network/element_types.hpp"

namespace valsalva::lumped {

namespace {

std::string quoted(const std::vector<std::string>& names)
{
  return fmt::format("\"{}\"", fmt::join(names, "\", \""));
}

int find_node(const std::vector<std::string>& names, const std::string& name)
{
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

/// What meets at one node.
struct Junction {
  std::vector<std::string> elements;
  std::vector<std::string> fixing;
  bool determined = false;
  bool is_port = false;
};

std::vector<Junction> junctions(const NetworkTopology& topology, const std::vector<Joined>& elements)
{
  std::vector<Junction> all(topology.node_names.size());
  for (const Joined& joined : elements)
    for (std::size_t terminal = 0; terminal < joined.nodes.size(); ++terminal) {
      Junction& j = all[static_cast<std::size_t>(joined.nodes[terminal])];
      j.elements.push_back(joined.element);
      if (joined.roles[terminal] == NodeRole::fixes) j.fixing.push_back(joined.element);
      j.determined = j.determined || joined.roles[terminal] != NodeRole::none;
    }
  for (int node : topology.port_nodes) all[static_cast<std::size_t>(node)].is_port = true;
  return all;
}

}  // namespace

NetworkTopology number_nodes(const NetworkSpec& spec)
{
  NetworkTopology topology;
  for (const ElementSpec& element : spec.elements) {
    std::vector<int> nodes;
    for (const std::string& terminal : find_element_type(element.type)->terminals) {
      const std::string& name = element.nodes.at(terminal);
      if (find_node(topology.node_names, name) < 0) topology.node_names.push_back(name);
      nodes.push_back(find_node(topology.node_names, name));
    }
    topology.element_nodes.push_back(std::move(nodes));
  }
  std::vector<CaseProblem> problems;
  for (const std::string& port : spec.ports) {
    const int node = find_node(topology.node_names, port);
    if (node < 0)
      problems.push_back(
          {"", 0, 0, fmt::format("port \"{}\"", port),
           topology.node_names.empty()
               ? "is not a node: the network has no elements. Join one to it, e.g. a pressure_source."
               : fmt::format("is not a node of the network{}. The nodes are {}.",
                             common::did_you_mean(port, topology.node_names), quoted(topology.node_names))});
    topology.port_nodes.push_back(node);
  }
  if (!problems.empty()) throw CaseError(std::move(problems));
  return topology;
}

void check_solvable(const NetworkTopology& topology, const std::vector<Joined>& elements)
{
  const std::vector<Junction> all = junctions(topology, elements);
  std::vector<CaseProblem> problems;
  for (std::size_t n = 0; n < all.size(); ++n) {
    const Junction& j = all[n];
    std::string message;
    if (j.fixing.size() > 1) {
      message = fmt::format(
          "has its pressure fixed by {} at once; only one element may do that. Put them on nodes of "
          "their own with a valve between, or give one a resistance.",
          quoted(j.fixing));
    } else if (!j.determined && j.elements.size() == 1 && !j.is_port) {
      message = fmt::format(
          "is joined to \"{}\" alone, so its flow has nowhere to go. Join a second element to it, or "
          "correct the name; the nodes are {}.",
          j.elements.front(), quoted(topology.node_names));
    } else if (!j.determined) {
      message = fmt::format(
          "joins only {}, none of which settles its pressure when the valves are closed. Add a "
          "windkessel3, a chamber or a pressure_source to it, or give a vessel that begins or ends there a "
          "compliance.",
          quoted(j.elements));
    }
    if (!message.empty())
      problems.push_back({"", 0, 0, fmt::format("node \"{}\"", topology.node_names[n]), std::move(message)});
  }
  if (!problems.empty()) throw CaseError(std::move(problems));
}

}  // namespace valsalva::lumped
