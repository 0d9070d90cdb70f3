// The checkpoints of a run, <folder>/checkpoints/checkpoint_<step>.h5: when they are written, how many are kept,
// and which one a run continues from. A checkpoint holds the case too: only keys that leave the solution alone
// (title, [output] without probes_z_cm, [checkpoint], time.end_s, time.stop_when_periodic_within) may change between a run and its continuation.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "casefile/case_file.hpp"
#include "common/checkpoint.hpp"
#include "common/comm.hpp"

namespace valsalva::run {

/// CaseError that names the keys of `now` by which it is another run than `then`, the case of `checkpoint`.
void check_same_run(const CaseFile& now, const CaseFile& then, const std::string& checkpoint);

struct Restart {
  Checkpoint file;
  std::vector<std::string> unreadable;  ///< why newer ones were passed over
};

/// What `--restart` means: a file, or "latest" for the newest one of `folder` that can be read; nothing without the
/// option, or if there is none and the folder is empty or `force` allows to begin anew. CaseError for another case. Collective.
std::optional<Restart> find_restart(const std::string& restart, const std::string& folder, bool force,
                                    const CaseFile& c, const Communicator& comm);

class RunCheckpoints {
 public:
  using SaveOrRestore = std::function<void(Checkpoint&)>;

  /// `state` is all that the computation needs to go on, `output` where its files end. `wall_s`: the clock of
  /// `due` now.
  RunCheckpoints(const std::string& folder, const CaseFile& c, const Communicator& comm, double wall_s,
                 SaveOrRestore state, SaveOrRestore output);

  /// Has the interval passed on the clock of this rank?
  bool due(double wall_s) const { return every_s_ > 0 && wall_s - last_wall_s_ >= every_s_; }
  /// Writes the checkpoint of this step, unless it is the one last written or continued from, and removes the
  /// oldest. Collective.
  void write(long step, double wall_s);
  /// Restores everything. Checkpoints of later steps are removed: the output is cut back to before them.
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
