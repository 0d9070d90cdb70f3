#include "run/check.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands.hpp"

namespace valsalva::app {

void add_check(CLI::App& app, Chosen& chosen)
{
  auto arguments = std::make_shared<CaseArguments>();
  CLI::App* command = app.add_subcommand(
      "check", "Validate a case and print what it will cost, from a few trial steps; writes nothing");
  add_case_arguments(*command, *arguments);
  command->callback([arguments, &chosen] {
    chosen.action = [arguments](const Communicator& comm) {
      const setup::Case c = read_case(*arguments);
      const std::string lines = with_places(c, [&] { return run::describe_case(c, comm); });
      if (comm.is_rank_0()) fmt::print("{}{}", lines, lines.ends_with('\n') ? "" : "\n");
      return 0;
    };
  });
}

}  // namespace valsalva::app
