#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands.hpp"
#include "common/output_folder.hpp"
#include "run/fit.hpp"

namespace valsalva::app {

namespace {

struct FitArguments {
  CaseArguments of_case;
  run::FitOptions options;
};

int fit(const FitArguments& arguments, Chosen& chosen, const Communicator& comm)
{
  const setup::Case c = read_case(arguments.of_case);
  run::FitOptions options = arguments.options;
  if (options.out_dir.empty()) options.out_dir = common::usual_output_folder(c.source.path()) + "-fit";
  common::check_output_folder(options.out_dir, options.force, comm);
  const int code = with_places(c, [&] { return run::fit_case(c, options, comm); });
  if (c.output.pictures) chosen.afterwards = [out = options.out_dir] { return draw("draw_fit.py", out); };
  return code;
}

}  // namespace

void add_fit(CLI::App& app, Chosen& chosen)
{
  auto arguments = std::make_shared<FitArguments>();
  CLI::App* command = app.add_subcommand("fit", "Fit free parameters of a 0D case to a measured beat");
  add_case_arguments(*command, arguments->of_case);
  command->add_option("--data", arguments->options.data_path,
                      "CSV of the measured beat (default: the case's)");
  command->add_option("-o,--out", arguments->options.out_dir, "Output folder (default: out/<case>-fit)");
  command->add_flag("--force", arguments->options.force, "Replace the output of an earlier run");
  command->callback([arguments, &chosen] {
    chosen.action = [arguments, &chosen](const Communicator& comm) { return fit(*arguments, chosen, comm); };
  });
}

}  // namespace valsalva::app
