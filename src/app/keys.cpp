#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands.hpp"
#include "setup/keys.hpp"

namespace valsalva::app {

void add_keys(CLI::App& app, Chosen& chosen)
{
  auto markdown = std::make_shared<bool>(false);
  CLI::App* command = app.add_subcommand("keys", "Print a commented template of all keys of a case");
  command->add_flag("--markdown", *markdown, "Print the page docs/keys.md instead");
  command->callback([markdown, &chosen] {
    chosen.action = [markdown](const Communicator& comm) {
      const casefile::KeyTable& keys = setup::case_keys();
      if (comm.is_rank_0())
        fmt::print("{}", *markdown ? casefile::keys_markdown(keys) : casefile::template_toml(keys));
      return 0;
    };
  });
}

}  // namespace valsalva::app
