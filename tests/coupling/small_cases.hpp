// The cases that tests of the coupling start from, with changes as after --set and with more TOML behind them.
#pragma once

#include <string>
#include <vector>

#include "casefile/case_file.hpp"
#include "setup/case_keys.hpp"

namespace valsalva::coupling {

using namespace setup;

using Changes = std::vector<std::string>;

/// A case of this folder, by its file's name.
inline CaseFile small_case(const std::string& file, const Changes& changes = {}, const std::string& more = "")
{
  const std::string folder = VALSALVA_SOURCE_DIR "/tests/coupling/";
  return CaseFile::parse("extends = \"" + file + "\"\n" + more, folder + "test.toml", case_keys(), changes);
}

inline CaseFile circulation_case(const Changes& changes = {}, const std::string& more = "")
{
  return small_case("circulation.toml", changes, more);
}

inline CaseFile tube_case(const Changes& changes = {}, const std::string& more = "")
{
  return small_case("tube.toml", changes, more);
}

}  // namespace valsalva::coupling
