// What a network is refused with.
#pragma once

#include "complaint.hpp"
#include "lumped/network/network.hpp"

namespace valsalva::lumped::testing {

/// The problems that building the network finds, one "key: message" per line; empty if it is accepted.
inline std::string refusal(const NetworkSpec& spec)
{
  return complaint([&] { const LumpedNetwork network(spec); });
}

}  // namespace valsalva::lumped::testing
