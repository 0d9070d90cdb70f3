#include "run/checkpoints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <regex>

#include "common/error.hpp"
#include "setup/same_run.hpp"

namespace valsalva::run {

namespace fs = std::filesystem;

namespace {

std::string folder_of(const std::string& out)
{
  return out + "/checkpoints";
}

std::string path_of(const std::string& out, long step)
{
  return fmt::format("{}/checkpoint_{:08}.h5", folder_of(out), step);
}

/// The steps of the complete checkpoints of a run, ascending, as one rank sees them.
std::vector<long> steps_in(const std::string& out)
{
  static const std::regex name(R"(checkpoint_(\d+)\.h5)");
  std::vector<long> steps;
  std::error_code no_folder;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_of(out), no_folder)) {
    std::smatch found;
    const std::string file = entry.path().filename().string();
    if (std::regex_match(file, found, name)) steps.push_back(std::stol(found[1]));
  }
  std::sort(steps.begin(), steps.end());
  return steps;
}

/// The same, as rank 0 sees them, on all ranks.
std::vector<long> agreed_steps_in(const std::string& out, const Communicator& comm)
{
  std::vector<long> steps;
  common::on_rank_0(comm, [&] { steps = steps_in(out); });
  steps.resize(static_cast<std::size_t>(comm.from_rank_0(static_cast<double>(steps.size()))));
  for (long& step : steps) step = std::lround(comm.from_rank_0(static_cast<double>(step)));
  return steps;
}

Checkpoint open_checked(const std::string& path, const setup::Case& c, const Communicator& comm)
{
  Checkpoint file = Checkpoint::open(path, comm.raw());
  std::string text;
  file("case", text);
  setup::check_same_run(c, text, path);
  return file;
}

}  // namespace

std::optional<Restart> find_restart(const std::string& restart, const std::string& folder, bool force,
                                    const setup::Case& c, const Communicator& comm)
{
  if (restart.empty()) return std::nullopt;
  if (restart != "latest") return Restart{open_checked(restart, c, comm), {}};
  std::vector<long> steps = agreed_steps_in(folder, comm);
  std::vector<std::string> unreadable;
  for (; !steps.empty(); steps.pop_back()) try {
      return Restart{open_checked(path_of(folder, steps.back()), c, comm), unreadable};
    } catch (const IoError& error) {
      unreadable.emplace_back(error.what());
    }
  if (!unreadable.empty())
    throw IoError(fmt::format("no checkpoint of '{}' can be read:\n{}", folder, fmt::join(unreadable, "\n")));
  std::error_code none;
  const bool occupied = comm.is_rank_0() && fs::exists(folder, none) && !fs::is_empty(folder, none);
  if (!comm.any(occupied) || force) return std::nullopt;
  throw CaseError("", "the output folder '" + folder +
                          "' holds no checkpoint to continue from; add --force to start again");
}

RunCheckpoints::RunCheckpoints(const std::string& folder, const setup::Case& c, const Communicator& comm,
                               double wall_s, SaveOrRestore state, SaveOrRestore output)
    : folder_(folder),
      case_text_(c.source.resolved_toml()),
      comm_(comm),
      every_s_(c.checkpoints.every_wall_s),
      keep_(static_cast<std::size_t>(c.checkpoints.keep)),
      state_(std::move(state)),
      output_(std::move(output)),
      last_wall_s_(wall_s)
{
  common::on_rank_0(comm, [&] { fs::create_directories(folder_of(folder)); });
}

void RunCheckpoints::remove_where(const std::function<bool(long)>& unwanted) const
{
  for (long step : steps_in(folder_))
    if (unwanted(step)) fs::remove(path_of(folder_, step));
  std::error_code gone;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_of(folder_)))
    if (entry.path().extension() == ".part") fs::remove(entry.path(), gone);  // of a run that was killed
}

void RunCheckpoints::write(long step, double wall_s)
{
  last_wall_s_ = wall_s;
  if (step == last_step_) return;
  const std::string path = path_of(folder_, step);
  Checkpoint file = Checkpoint::create(path, comm_.raw());
  file("case", case_text_);
  file("step", step);
  state_(file);
  output_(file);
  file.close();
  last_ = path;
  last_step_ = step;
  common::on_rank_0(comm_, [&] {
    const std::vector<long> steps = steps_in(folder_);
    if (steps.size() <= keep_) return;
    const long oldest = steps[steps.size() - keep_];
    remove_where([&](long s) { return s < oldest; });
  });
}

void RunCheckpoints::restore(Checkpoint& file)
{
  file("step", last_step_);
  last_ = file.path();
  state_(file);
  common::on_rank_0(comm_, [&] { remove_where([&](long s) { return s > last_step_; }); });
  output_(file);
}

}  // namespace valsalva::run
