// The end of a program on many ranks: one rank reports what went wrong, all return the same code, none waits
// for ever for another that has failed alone.
#pragma once

#include <functional>

#include "common/comm.hpp"

namespace valsalva::common {

/// Runs `work` and turns its exceptions into exit codes. If all ranks have come to an end, the lowest rank
/// that failed prints its message and all return the largest code. If others are still at work some seconds
/// after this rank failed, they wait for it in vain: it prints and ends them all (MPI_Abort). Collective.
int end_together(const Communicator& comm, const std::function<int()>& work, double patience_s = 10.0);

/// Runs `work` and, if it throws here, `note` before the exception goes on: on rank 0 if all ranks have failed,
/// else on each that has, after some seconds. `note` must call nothing collective and not throw. Collective.
void note_failure(const Communicator& comm, const std::function<void()>& work,
                  const std::function<void()>& note, double patience_s = 5.0);

}  // namespace valsalva::common
