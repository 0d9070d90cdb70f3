#include "coupling/run.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands.hpp"
#include "common/output_folder.hpp"

namespace valsalva::app {

namespace {

struct RunArguments {
  CaseArguments of_case;
  coupling::RunOptions options;
};

/// What to type to continue: the same case with the same --set.
std::string continue_command(const CaseArguments& of_case, const std::string& out_dir)
{
  std::string command = fmt::format("valsalva run {} -o {} --restart latest", of_case.path, out_dir);
  for (const std::string& one : of_case.overrides) command += fmt::format(" --set '{}'", one);
  return command;
}

int run(const RunArguments& arguments, Chosen& chosen, const Communicator& comm)
{
  const CaseFile case_file = read_case(arguments.of_case);
  coupling::RunOptions options = arguments.options;
  options.case_path = case_file.path();
  if (options.out_dir.empty())
    options.out_dir = common::usual_output_folder(options.case_path) + (options.lumped ? "-lumped" : "");
  if (options.restart.empty()) common::check_output_folder(options.out_dir, options.force, comm);
  options.continue_command = continue_command(arguments.of_case, options.out_dir);
  try {
    const int code = coupling::run_case(case_file, options);
    const common::CaseTable& output = case_file.section("output");
    if (output.flag("pictures"))
      chosen.afterwards = [out = options.out_dir, report = output.flag("report")] {
        return draw(report ? "report_run.py" : "draw_run.py", out);
      };
    return code;
  } catch (const CaseError& error) {
    throw case_file.locate(error);
  }
}

}  // namespace

void add_run(CLI::App& app, Chosen& chosen)
{
  auto arguments = std::make_shared<RunArguments>();
  CLI::App* command = app.add_subcommand("run", "Run a case (3D-0D, or 0D alone, as the case says)");
  add_case_arguments(*command, arguments->of_case);
  command->add_option("-o,--out", arguments->options.out_dir, "Output folder (default: out/<case>)");
  command->add_flag(
      "--lumped", arguments->options.lumped,
      "In 0D: the surrogate of the section [surrogate] in place of the 3D root (out/<case>-lumped)");
  command->add_flag("--force", arguments->options.force, "Replace the output of an earlier run");
  command->add_option("--restart", arguments->options.restart,
                      "Continue the run in the output folder from a checkpoint: a file, or latest");
  command->callback([arguments, &chosen] {
    chosen.action = [arguments, &chosen](const Communicator& comm) { return run(*arguments, chosen, comm); };
  });
}

}  // namespace valsalva::app
