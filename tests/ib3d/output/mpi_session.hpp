// MPI for the tests of this folder, which open files with MPI_COMM_WORLD: started and ended here unless the
// program's main does so. The same tests hold on any number of ranks.
#pragma once

#include <mpi.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <system_error>

#include "common/comm.hpp"

namespace valsalva::ib3d {

inline void start_mpi()
{
  struct Session {
    Session()
    {
      int started = 0;
      MPI_Initialized(&started);
      own = started == 0;
      if (own) common::start_mpi();
    }
    ~Session()
    {
      int ended = 0;
      MPI_Finalized(&ended);
      if (own && ended == 0) MPI_Finalize();
    }
    bool own = false;
  };
  static const Session session;
}

inline int mpi_rank()
{
  start_mpi();
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

inline int mpi_size()
{
  start_mpi();
  int size = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  return size;
}

/// A folder of rank 0's process, removed when that ends.
struct ScratchFolder {
  ScratchFolder()
  {
    int process = mpi_rank() == 0 ? static_cast<int>(::getpid()) : 0;
    MPI_Bcast(&process, 1, MPI_INT, 0, MPI_COMM_WORLD);
    path = std::filesystem::temp_directory_path() / ("valsalva_" + std::to_string(process));
    owned = mpi_rank() == 0;
    if (owned) std::filesystem::create_directories(path);
    MPI_Barrier(MPI_COMM_WORLD);
  }
  ~ScratchFolder()
  {
    std::error_code ignored;
    if (owned) std::filesystem::remove_all(path, ignored);
  }
  std::filesystem::path path;
  bool owned = false;
};

/// The same path in a fresh folder on every rank.
inline std::string shared_file(const std::string& name)
{
  static const ScratchFolder folder;
  return folder.path / name;
}

}  // namespace valsalva::ib3d
