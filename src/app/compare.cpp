#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands.hpp"

namespace valsalva::app {

namespace {

struct CompareArguments {
  std::vector<std::string> runs;
  std::vector<std::string> data;
  std::string out = "out/compare";
  bool html = false;
};

std::vector<std::string> words(const CompareArguments& arguments)
{
  std::vector<std::string> all = arguments.runs;
  for (const std::string& file : arguments.data) all.insert(all.end(), {"--data", file});
  all.insert(all.end(), {"--out", arguments.out});
  if (arguments.html) all.emplace_back("--html");
  return all;
}

}  // namespace

void add_compare(CLI::App& app, Chosen& chosen)
{
  auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command =
      app.add_subcommand("compare", "Numbers and traces of runs (3D or 0D) and measurements side by side");
  command->add_option("runs", arguments->runs, "Output folders of runs; the first is what others differ from")
      ->required()
      ->check(CLI::ExistingDirectory);
  command
      ->add_option("--data", arguments->data,
                   "Measured beat: CSV with t_s, Q_..._ml_s, p_..._mmHg (repeatable)")
      ->allow_extra_args(false)
      ->check(CLI::ExistingFile);
  command->add_option("-o,--out", arguments->out, "Folder for tables and pictures")->capture_default_str();
  command->add_flag("--html", arguments->html, "Write one page with all of it as well");
  command->callback([arguments, &chosen] {
    chosen.afterwards = [arguments] { return run_script("compare_runs.py", words(*arguments)); };
  });
}

}  // namespace valsalva::app
