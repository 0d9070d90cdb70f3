// valsalva: the front door. Reads the command line, does what the chosen subcommand says, reports errors
// once. Exit codes: 0 done, 2 bad case or command line, 3 numerical failure, 4 input/output, 1 a mistake of
// the program.
#include <fmt/format.h>
#include <mpi.h>

#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "common/end_together.hpp"
#include "common/nearest_name.hpp"
#include "valsalva_version.hpp"

namespace {

using namespace valsalva;

constexpr const char* kAbout =
    "Blood flow through the aortic valve: a 3D immersed boundary model of the root, coupled to a lumped\n"
    "circulation. A case file (TOML) says what is simulated; a run writes a folder with tables, fields, "
    "pictures\n"
    "and a report.";

constexpr const char* kFurther = R"(Examples:
  valsalva check cases/aortic_root                   what the case will build, need and take
  valsalva run cases/aortic_root -o out/first        one beat of the valve on one rank
  mpirun -np 4 valsalva run cases/aortic_root        the same on four ranks, into out/aortic_root
  valsalva run cases/aortic_root --restart latest    goes on from the last checkpoint
  valsalva run cases/lumped_heart                    a circulation without a 3D part
  valsalva keys > my_case.toml                       every key of a case with unit, range and default

`valsalva COMMAND --help` tells more about a command.

Files:
  CASE/case.toml        the case; docs/keys.md lists its keys
  out/CASE              the output folder unless -o names another; docs/outputs.md explains every file

Exit codes:
  0  done; also after SIGTERM or SIGINT, with a checkpoint written
  1  a mistake of the program
  2  bad case or command line: every mistake with its place, what is allowed and the repair
  3  the numbers went bad: step, time and remedy; the output up to then stays
  4  a file could not be read or written)";

/// The exit code of a command line that ends here (--help, --version, a mistake), printed by one rank; -1 to
/// go on.
int parse(CLI::App& app, int argc, char** argv, const Communicator& comm)
{
  try {
    app.parse(argc, argv);
    return -1;
  } catch (const CLI::ParseError& end) {
    const bool is_question = end.get_exit_code() == 0;
    std::vector<std::string> commands;
    for (const CLI::App* command : app.get_subcommands({})) commands.push_back(command->get_name());
    const std::string word = argc > 1 ? argv[1] : "";
    const bool is_unknown = !word.starts_with("-") && !word.empty() && app.get_subcommands().empty();
    if (comm.is_rank_0() && !is_question && is_unknown)
      fmt::print(stderr, "valsalva: no command '{}'{}; known are {}\n", word,
                 common::did_you_mean(word, commands), common::one_of(commands));
    else if (comm.is_rank_0())
      app.exit(end);
    return is_question ? 0 : common::kCaseErrorCode;
  }
}

}  // namespace

int main(int argc, char** argv)
{
  common::start_mpi(&argc, &argv);
  app::Chosen chosen;
  int code = 0;
  bool is_rank_0 = true;
  {
    const Communicator comm(MPI_COMM_WORLD);
    is_rank_0 = comm.is_rank_0();
    CLI::App app(kAbout);
    app.footer(kFurther);
    app.set_version_flag("--version",
                         fmt::format("valsalva {} ({})\n{}\n{}", kVersion, kGitHash, kCompiler, kLibraries));
    app.require_subcommand(1);
    app::add_run(app, chosen);
    app::add_fit(app, chosen);
    app::add_calibrate(app, chosen);
    app::add_check(app, chosen);
    app::add_keys(app, chosen);
    app::add_report(app, chosen);
    app::add_compare(app, chosen);
    code = parse(app, argc, argv, comm);
    if (code < 0) code = common::end_together(comm, [&] { return chosen.action ? chosen.action(comm) : 0; });
  }
  MPI_Finalize();
  if (is_rank_0 && code == 0 && chosen.afterwards) code = chosen.afterwards();
  return code;
}
