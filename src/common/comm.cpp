#include "common/comm.hpp"

#include <csignal>
#include <cstdlib>
#include <exception>

#include "common/hdf5_id.hpp"

namespace valsalva::common {

void start_mpi(int* argc, char*** argv)
{
  // Nothing here uses Open MPI's shared file pointers, and they hang on the named semaphore that a killed run
  // leaves behind.
  setenv("OMPI_MCA_sharedfp", "^sm", 0);
  // A file that outgrows the limit on file sizes is then an error of the write, not the end of the program.
  std::signal(SIGXFSZ, SIG_IGN);
  // HDF5 closes what is open when the program ends, and crashes over a file that a full disk has cut short. It
  // does so by atexit and, if it starts after MPI, also within MPI_Finalize.
  H5dont_atexit();
  H5open();
  MPI_Init(argc, argv);
}

void on_rank_0(const Communicator& comm, const std::function<void()>& work)
{
  std::vector<double> none;
  on_rank_0(comm, work, none);
}

void on_rank_0(const Communicator& comm, const std::function<void()>& work, std::vector<double>& values)
{
  std::exception_ptr failure;
  std::vector<double> message(1 + values.size());
  if (comm.is_rank_0()) try {
      work();
    } catch (...) {
      failure = std::current_exception();
      message[0] = end_of(failure).code;
    }
  std::copy(values.begin(), values.end(), message.begin() + 1);
  if (comm.size() > 1) MPI_Bcast(message.data(), static_cast<int>(message.size()), MPI_DOUBLE, 0, comm.raw());
  if (failure) std::rethrow_exception(failure);
  switch (static_cast<int>(message[0])) {
    case 0:
      break;
    case kCaseErrorCode:
      throw CaseError(std::vector<CaseProblem>{});
    case kSolverErrorCode:
      throw SolverError("");
    case kIoErrorCode:
      throw IoError("");
    default:
      throw std::runtime_error("rank 0 failed");
  }
  std::copy(message.begin() + 1, message.end(), values.begin());
}

}  // namespace valsalva::common
