#include "run/calibrate.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "app/commands.hpp"
#include "common/output_folder.hpp"

namespace valsalva::app {

namespace {

int calibrate(run::CalibrateOptions options, Chosen& chosen, const Communicator& comm)
{
  const setup::Case c =
      setup::read_case((std::filesystem::path(options.run_dir) / "case.resolved.toml").string(), {},
                       setup::SourceTables::leave_out);
  if (options.out_dir.empty())
    options.out_dir =
        std::filesystem::path(options.run_dir + "/").lexically_normal().parent_path().string() + "-surrogate";
  common::check_output_folder(options.out_dir, options.force, comm);
  const int code = with_places(c, [&] { return run::calibrate(c, options, comm); });
  chosen.afterwards = [out = options.out_dir] { return draw("draw_fit.py", out); };
  return code;
}

}  // namespace

void add_calibrate(CLI::App& app, Chosen& chosen)
{
  auto options = std::make_shared<run::CalibrateOptions>();
  CLI::App* command =
      app.add_subcommand("calibrate", "Find the 0D surrogate of the root ([surrogate]) that fits a 3D run");
  command->add_option("run", options->run_dir, "Output folder of the 3D run")
      ->required()
      ->check(CLI::ExistingDirectory);
  command->add_option("-o,--out", options->out_dir, "Output folder (default: RUN-surrogate)");
  command->add_option("--beat", options->beat, "Which beat of the run, from 1")->capture_default_str();
  command->add_flag("--force", options->force, "Replace the output of an earlier run");
  command->callback([options, &chosen] {
    chosen.action = [options, &chosen](const Communicator& comm) {
      return calibrate(*options, chosen, comm);
    };
  });
}

}  // namespace valsalva::app
