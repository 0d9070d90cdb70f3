#include <CLI/CLI.hpp>
#include <filesystem>

#include "app/commands.hpp"
#include "setup/case_keys.hpp"

namespace valsalva::app {

void add_case_arguments(CLI::App& command, CaseArguments& arguments)
{
  command.add_option("case", arguments.path, "Case file, or a folder with a case.toml")->required();
  command.add_option("--set", arguments.overrides, "Change a key: --set grid.finest_cm=0.15625 (repeatable)")
      ->allow_extra_args(false);
}

std::string case_file_path(const CaseArguments& arguments)
{
  const std::filesystem::path path(arguments.path);
  return std::filesystem::is_directory(path) ? (path / "case.toml").string() : path.string();
}

CaseFile read_case(const CaseArguments& arguments)
{
  return CaseFile::read(case_file_path(arguments), setup::case_keys(), arguments.overrides);
}

}  // namespace valsalva::app
