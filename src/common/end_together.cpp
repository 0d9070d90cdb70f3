#include "common/end_together.hpp"

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <string>
#include <thread>

#include "common/error.hpp"

namespace valsalva::common {

namespace {

End outcome_of(const std::function<int()>& work)
{
  try {
    const int code = work();
    if (std::fflush(stdout) != 0)
      throw IoError(std::string("cannot write to the terminal: ") + std::strerror(errno));
    return {code, ""};
  } catch (...) {
    return end_of(std::current_exception());
  }
}

void print(const End& end)
{
  const std::string before = end.code == kCaseErrorCode ? "this case cannot run\n" : "";
  std::fputs(("valsalva: " + before + end.message + '\n').c_str(), stderr);
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

/// A communicator of its own: a collective call of the work must not meet the barrier of a rank that failed.
class Ends {
 public:
  explicit Ends(const Communicator& comm) : copied_(comm.size() > 1), comm_(comm.raw())
  {
    if (copied_) MPI_Comm_dup(comm.raw(), &comm_);
  }
  Ends(const Ends&) = delete;
  Ends& operator=(const Ends&) = delete;
  Communicator comm() const { return Communicator(comm_); }
  /// Collective; skipped by ranks that have lost the others.
  void free()
  {
    if (copied_) MPI_Comm_free(&comm_);
  }

 private:
  bool copied_;
  MPI_Comm comm_;
};

}  // namespace

int end_together(const Communicator& comm, const std::function<int()>& work, double patience_s)
{
  Ends copy(comm);
  const Communicator ends = copy.comm();
  const End end = outcome_of(work);
  if (!all_arrive(ends, end.code != 0, patience_s)) {
    print(end);
    MPI_Abort(ends.raw(), end.code);
  }
  const bool speaks = !end.message.empty();
  const double speaker = ends.min(speaks ? ends.rank() : ends.size());
  if (speaks && ends.rank() == static_cast<int>(speaker)) print(end);
  const int code = static_cast<int>(ends.max(end.code));
  copy.free();
  return code;
}

void note_failure(const Communicator& comm, const std::function<void()>& work,
                  const std::function<void()>& note, double patience_s)
{
  Ends copy(comm);
  try {
    work();
  } catch (...) {
    if (!all_arrive(copy.comm(), true, patience_s) || comm.is_rank_0()) note();
    throw;
  }
  copy.free();
}

}  // namespace valsalva::common
