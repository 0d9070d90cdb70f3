#include "common/output_folder.hpp"

#include <filesystem>
#include <system_error>

#include "common/error.hpp"
#include "common/text_file.hpp"

namespace valsalva::common {

namespace fs = std::filesystem;

namespace {

constexpr const char* kCaseFile = "case.resolved.toml";

enum class State { usable, occupied, foreign, no_folder };

State state_of(const fs::path& folder, bool force)
{
  std::error_code error;
  if (!fs::exists(folder, error)) return State::usable;
  if (!fs::is_directory(folder, error)) return State::no_folder;
  if (fs::is_empty(folder, error)) return State::usable;
  if (!force) return State::occupied;
  return fs::exists(folder / kCaseFile, error) ? State::usable : State::foreign;
}

}  // namespace

void check_output_folder(const std::string& folder, bool force, const Communicator& comm)
{
  const double found = comm.is_rank_0() ? static_cast<double>(state_of(folder, force)) : 0.0;
  const std::string name = "the output folder '" + folder + "' ";
  switch (static_cast<State>(static_cast<int>(comm.from_rank_0(found)))) {
    case State::usable:
      return;
    case State::occupied:
      throw CaseError("", name + "is not empty; add --force to replace it or give another with -o");
    case State::foreign:
      throw CaseError("", name +
                              "holds no run of Valsalva (no case.resolved.toml), so --force leaves it alone; "
                              "give another with -o");
    case State::no_folder:
      throw CaseError("", name + "is a file; give another with -o");
  }
}

void create_output_folder(const std::string& folder, bool force, const std::string& resolved_case,
                          const Communicator& comm)
{
  check_output_folder(folder, force, comm);
  on_rank_0(comm, [&] {
    fs::remove_all(folder);
    fs::create_directories(folder);
    write_text_file(fs::path(folder) / kCaseFile, resolved_case);
  });
}

void continue_output_folder(const std::string& folder, const std::string& resolved_case,
                            const Communicator& comm)
{
  const fs::path file = fs::path(folder) / kCaseFile;
  std::error_code error;
  if (comm.any(comm.is_rank_0() && !fs::exists(file, error)))
    throw CaseError(
        "", "the output folder '" + folder +
                "' holds no run to continue (no case.resolved.toml); name the folder of the run with -o");
  on_rank_0(comm, [&] { write_text_file(file, resolved_case); });
}

std::string usual_output_folder(const std::string& case_path)
{
  const fs::path file = fs::absolute(case_path).lexically_normal();
  std::string name = file.parent_path().filename().string();
  if (file.stem() != "case") name.append(name.empty() ? "" : "-").append(file.stem().string());
  return "out/" + (name.empty() ? std::string("run") : name);
}

}  // namespace valsalva::common
