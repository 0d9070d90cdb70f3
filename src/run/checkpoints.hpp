// The checkpoints of a run, <folder>/checkpoints/checkpoint_<step>.h5: when they are written, how many are kept,
// and which one a run continues from. A checkpoint holds the case too; setup/same_run.hpp says what of it may change.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "common/checkpoint.hpp"
#include "common/comm.hpp"
#include "setup/case.hpp"

namespace valsalva::run {

struct Restart {
  Checkpoint file;
  std::vector<std::string> unreadable;  ///< why newer ones were skipped
};

/// What `--restart` means: a file, or "latest" for the newest one of `folder` that can be read; nothing without the
/// option, or if there is none and the folder is empty or `force` allows a new start. CaseError for another case.
/// Collective.
std::optional<Restart> find_restart(const std::string& restart, const std::string& folder, bool force,
                                    const setup::Case& c, const Communicator& comm);

class RunCheckpoints {
 public:
  using SaveOrRestore = std::function<void(Checkpoint&)>;

  /// `state` saves or restores all that the computation needs to continue, `output` where its files end. `wall_s`: the clock of
  /// `due` now.
  RunCheckpoints(const std::string& folder, const setup::Case& c, const Communicator& comm, double wall_s,
                 SaveOrRestore state, SaveOrRestore output);

  /// Has the interval passed on the clock of this rank?
  bool due(double wall_s) const { return every_s_ > 0 && wall_s - last_wall_s_ >= every_s_; }
  /// Writes the checkpoint of this step, unless it is the one last written or continued from, and removes the
  /// oldest. Collective.
  void write(long step, double wall_s);
  /// Restores everything. Checkpoints of later steps are removed, since the output is truncated to an earlier step.
  /// Collective.
  void restore(Checkpoint& file);

  /// The newest one; empty if there is none yet.
  const std::string& last() const { return last_; }

 private:
  void remove_where(const std::function<bool(long step)>& unwanted) const;

  std::string folder_, case_text_;
  Communicator comm_;
  double every_s_;
  std::size_t keep_;
  SaveOrRestore state_, output_;
  std::string last_;
  std::int64_t last_step_ = -1;
  double last_wall_s_;
};

}  // namespace valsalva::run
