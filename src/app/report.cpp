#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands.hpp"

namespace valsalva::app {

void add_report(CLI::App& app, Chosen& chosen)
{
  auto out = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand(
      "report", "Write the report of a run, also while it is running: one page that opens in a browser");
  command->add_option("out", *out, "Output folder of the run")->required()->check(CLI::ExistingDirectory);
  command->callback(
      [out, &chosen] { chosen.afterwards = [out] { return run_script("report_run.py", {*out}); }; });
}

}  // namespace valsalva::app
