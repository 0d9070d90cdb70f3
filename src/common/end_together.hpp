// The end of a program on many ranks: one rank reports what went wrong, all return the same code, none waits
// for ever for another that has failed alone.
#pragma once

#include <functional>

#include "common/comm.hpp"

namespace valsalva::common {

inline constexpr int kCaseErrorCode = 2;
inline constexpr int kSolverErrorCode = 3;
inline constexpr int kIoErrorCode = 4;
inline constexpr int kProgramErrorCode = 1;

/// Runs `work` and turns its exceptions into exit codes. If all ranks have come to an end, the lowest rank
/// that failed prints its message and all return the largest code. If others are still at work some seconds
/// after this rank failed, they wait for it in vain: it prints and ends them all (MPI_Abort). Collective.
int end_together(const Communicator& comm, const std::function<int()>& work, double patience_s = 10.0);

}  // namespace valsalva::common
