// MPI around the tests of a program whose main does not start it (gtest_main). Include in one file per program:
// the initialisation of the constant below registers the environment.
#pragma once

#include <gtest/gtest.h>
#include <mpi.h>

#include <memory>

namespace valsalva::ib3d {

class MpiEnvironment : public ::testing::Environment {
 public:
  void SetUp() override
  {
    int started = 0;
    MPI_Initialized(&started);
    if (started == 0) MPI_Init(nullptr, nullptr);
  }
  void TearDown() override
  {
    int ended = 0;
    MPI_Finalized(&ended);
    if (ended == 0) MPI_Finalize();
  }
};

/// GoogleTest owns the environment.
inline const ::testing::Environment* const kMpi =
    ::testing::AddGlobalTestEnvironment(std::make_unique<MpiEnvironment>().release());

}  // namespace valsalva::ib3d
