#include "run/run.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands.hpp"
#include "common/output_folder.hpp"

namespace valsalva::app {

namespace {

constexpr const char* kFurther =
    R"(A run goes from the start of a case, or from a checkpoint, to time.end_s. A case with [[opening]] is a 3D root coupled
to its lumped network and runs on as many ranks as mpirun starts; one without is the network alone.

While it runs:
  A line every output.progress_every_s seconds tells step, time, pressures, flow and the time left.
  Ctrl-C or SIGTERM finishes the step, writes a checkpoint and ends with exit code 0.
  `valsalva report OUT` writes the report of what there is so far.

What it writes into the output folder (docs/outputs.md):
  case.resolved.toml  run.json  log.txt          the case with all defaults; who, where, how long; what was said
  step.csv openings.csv probes.csv beats.csv     every step; pressures and flows; probes; numbers per beat
  fields/fields.hdf.series                       pressure and velocity, for ParaView
  structure/{leaflets,markers}.hdf.series        the leaflets' fibres; passive markers; wall.hdf: the wall
  checkpoints/  pictures/  report.html

Examples:
  valsalva run cases/aortic_root
  valsalva run cases/aortic_root --set grid.finest_cm=0.15625 --set time.end_s=0.2 -o out/smoke
  valsalva run cases/aortic_root --set element.arteries.C_ml_mmHg=1.5 -o out/stiff
  mpirun -np 4 valsalva run cases/aortic_root/paper.toml -o out/paper --restart latest --force
      as in a job script that is started again and again: from the last checkpoint, or from the start

Exit codes: 0 done or stopped by a signal, 2 bad case or command line, 3 numerical failure, 4 input or output.)";

struct RunArguments {
  CaseArguments of_case;
  run::RunOptions options;
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
  const setup::Case c = read_case(arguments.of_case);
  run::RunOptions options = arguments.options;
  options.case_path = c.source.path();
  if (options.out_dir.empty())
    options.out_dir = common::usual_output_folder(options.case_path) + (options.lumped ? "-lumped" : "");
  if (options.restart.empty()) common::check_output_folder(options.out_dir, options.force, comm);
  options.continue_command = continue_command(arguments.of_case, options.out_dir);
  const int code = with_places(c, [&] { return run::run_case(c, options, comm); });
  if (c.output.pictures)
    chosen.afterwards = [out = options.out_dir, report = c.output.report] {
      return draw(report ? "report_run.py" : "draw_run.py", out);
    };
  return code;
}

}  // namespace

void add_run(CLI::App& app, Chosen& chosen)
{
  auto arguments = std::make_shared<RunArguments>();
  CLI::App* command = app.add_subcommand("run", "Run a case (3D-0D, or 0D alone, as the case says)");
  command->footer(kFurther);
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
