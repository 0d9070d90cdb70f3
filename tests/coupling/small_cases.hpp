// The cases that tests of the coupling start from, with changes as after --set and with more TOML behind them.
#pragma once

#include <string>
#include <vector>

#include "setup/read_case.hpp"

namespace valsalva::coupling {

using Changes = std::vector<std::string>;

/// A case of this folder, by its file's name.
inline setup::Case small_case(const std::string& file, const Changes& changes = {},
                              const std::string& more = "")
{
  const std::string folder = VALSALVA_SOURCE_DIR "/tests/coupling/";
  return setup::parse_case("extends = \"" + file + "\"\n" + more, folder + "test.toml", changes);
}

inline setup::Case circulation_case(const Changes& changes = {}, const std::string& more = "")
{
  return small_case("circulation.toml", changes, more);
}

inline setup::Case tube_case(const Changes& changes = {}, const std::string& more = "")
{
  return small_case("tube.toml", changes, more);
}

}  // namespace valsalva::coupling
