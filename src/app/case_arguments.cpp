#include <CLI/CLI.hpp>
#include <filesystem>

#include "app/commands.hpp"

namespace valsalva::app {

void add_case_arguments(CLI::App& command, CaseArguments& arguments)
{
  command.add_option("case", arguments.path, "Case file, or a folder with a case.toml")->required();
  command.add_option("--set", arguments.overrides, "Change a key: --set grid.finest_cm=0.15625 (repeatable)")
      ->allow_extra_args(false);
}

setup::Case read_case(const CaseArguments& arguments)
{
  const std::filesystem::path path(arguments.path);
  return setup::read_case((std::filesystem::is_directory(path) ? path / "case.toml" : path).string(),
                          arguments.overrides);
}

}  // namespace valsalva::app
