#include "common/end_together.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <string>
#include <thread>

#include "common/error.hpp"

namespace valsalva::common {

namespace {

struct End {
  int code = 0;
  std::string message;
};

End end_of(const std::function<int()>& work)
{
  try {
    return {work(), ""};
  } catch (const CaseError& error) {
    return {kCaseErrorCode, error.what()};
  } catch (const SolverError& error) {
    return {kSolverErrorCode, error.what()};
  } catch (const IoError& error) {
    return {kIoErrorCode, error.what()};
  } catch (const std::exception& error) {
    return {kProgramErrorCode, std::string("a mistake of the program, please report it: ") + error.what()};
  }
}

void print(const End& end)
{
  fmt::print(stderr, "valsalva: {}{}\n", end.code == kCaseErrorCode ? "this case cannot run\n" : "",
             end.message);
  std::fflush(stderr);
}

/// True if all ranks arrive before the patience of a rank that failed is at an end.
bool all_arrive(const Communicator& comm, bool failed, double patience_s)
{
  if (comm.size() == 1) return true;
  MPI_Request arrival;
  MPI_Ibarrier(comm.raw(), &arrival);
  const auto start = std::chrono::steady_clock::now();
  for (int here = 0;;) {
    MPI_Test(&arrival, &here, MPI_STATUS_IGNORE);
    if (here) return true;
    const double waited = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (failed && waited > patience_s) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

}  // namespace

int end_together(const Communicator& comm, const std::function<int()>& work, double patience_s)
{
  // A collective of `work` on the same communicator must not meet the barrier of a rank that failed.
  MPI_Comm own = comm.raw();
  if (comm.size() > 1) MPI_Comm_dup(comm.raw(), &own);
  const Communicator ends(own);
  const End end = end_of(work);
  if (!all_arrive(ends, end.code != 0, patience_s)) {
    print(end);
    MPI_Abort(own, end.code);
  }
  const bool speaks = !end.message.empty();
  const double speaker = ends.min(speaks ? ends.rank() : ends.size());
  if (speaks && ends.rank() == static_cast<int>(speaker)) print(end);
  const int code = static_cast<int>(ends.max(end.code));
  if (ends.size() > 1) MPI_Comm_free(&own);
  return code;
}

}  // namespace valsalva::common
