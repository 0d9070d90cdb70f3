#include "setup/aortic_valve.hpp"

#include <algorithm>

#include "setup/surrogate.hpp"

namespace valsalva::setup {

AorticValve find_aortic_valve(const lumped::NetworkSpec& spec)
{
  const auto is_chamber = [&](const std::string& node) {
    return std::any_of(spec.elements.begin(), spec.elements.end(),
                       [&](const auto& e) { return e.type == "chamber" && e.nodes.at("node") == node; });
  };
  const auto rank = [&](const lumped::ElementSpec& e) {
    if (e.type != "valve" && e.type != "orifice_valve") return 0;
    if (e.name == kSurrogateName) return 3;
    return is_chamber(e.nodes.at("from")) && !is_chamber(e.nodes.at("to")) ? 2 : 1;
  };
  const auto aortic = std::max_element(spec.elements.begin(), spec.elements.end(),
                                       [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  if (aortic == spec.elements.end() || rank(*aortic) == 0) return {};
  return {"Q_" + aortic->name + "_ml_s", "p_" + aortic->nodes.at("from") + "_mmHg",
          "p_" + aortic->nodes.at("to") + "_mmHg"};
}

}  // namespace valsalva::setup
