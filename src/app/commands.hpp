// The subcommands of `valsalva`. Each `add_...` registers its options and, if the user chose it, leaves in
// `chosen` what is to be done; main does it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "common/comm.hpp"
#include "setup/read_case.hpp"

namespace CLI {
class App;
}

namespace valsalva::app {

struct Chosen {
  std::function<int(const Communicator&)> action;  ///< returns the exit code; collective
  std::function<int()> afterwards;  ///< the same on rank 0 after MPI has ended, if all went well
};

void add_run(CLI::App& app, Chosen& chosen);
void add_fit(CLI::App& app, Chosen& chosen);
void add_calibrate(CLI::App& app, Chosen& chosen);
void add_check(CLI::App& app, Chosen& chosen);
void add_keys(CLI::App& app, Chosen& chosen);
void add_report(CLI::App& app, Chosen& chosen);
void add_compare(CLI::App& app, Chosen& chosen);

/// The case of a command line: `path` is a case file or a folder with a case.toml.
struct CaseArguments {
  std::string path;
  std::vector<std::string> overrides;
};

/// Adds the case and its `--set key=value` to a subcommand.
void add_case_arguments(CLI::App& command, CaseArguments& arguments);
setup::Case read_case(const CaseArguments& arguments);
/// `work()`, whose refusals get the places of the keys that they name.
template <class Work>
auto with_places(const setup::Case& c, Work&& work)
{
  try {
    return work();
  } catch (const CaseError& error) {
    throw c.source.locate(error);
  }
}

/// Runs /usr/bin/python3 scripts/`name` with the arguments and returns its exit code. Not while MPI is at work.
int run_script(const std::string& name, std::vector<std::string> arguments);
/// The same with an output folder whose results are complete without pictures: a failure is a warning, the code 0.
int draw(const std::string& name, const std::string& out_dir);

}  // namespace valsalva::app
