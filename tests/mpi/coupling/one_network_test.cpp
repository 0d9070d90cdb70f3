// The 0D network on several ranks: rank 0 integrates it, and the others have its numbers bit for bit whatever their own
// processors would have made of it.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "common/error.hpp"
#include "coupling/circulation.hpp"
#include "lumped/specs.hpp"
#include "setup/build_model.hpp"
#include "setup/read_case.hpp"

namespace valsalva::coupling {
namespace {

constexpr double kDt = 2e-3;

/// The root between ventricle and arteries; `Rp` tells the network of one rank from that of another.
lumped::NetworkSpec network(double Rp)
{
  using namespace lumped::testing;
  return {{pressure_table("ventricle", "lv", {0, 0.1}, {80, 120}),
           windkessel("arteries", "ao", 0.033, Rp, 1.75, 85)},
          {"lv", "ao"},
          0.0};
}

struct Course {
  std::vector<double> numbers;
  long evaluations = 0;
};

/// Twenty steps with everything that the coupling asks for.
Course course(const Communicator& comm, double Rp)
{
  Circulation circulation(network(Rp), comm);
  Eigen::Matrix2d G;
  G << 1, -1, -1, 1;
  Course c;
  std::vector<double> Q{-50, 50};
  for (int n = 0; n < 20; ++n) {
    const Eigen::VectorXd p = circulation.mean_pressures(kDt, Q, Eigen::Vector2d(-60 - n, 60 + n));
    const Eigen::VectorXd phi = circulation.close(kDt, Q, Eigen::Vector2d(-90, 90), kDt / 0.003 * G, p);
    circulation.advance(kDt, Q, {-60 - phi[0], 60 + phi[1]});
    Q = {-60 - phi[0], 60 + phi[1]};
    c.numbers.insert(c.numbers.end(),
                     {p[0], p[1], phi[0], phi[1], circulation.pressures(Q)[1], circulation.state().t});
    c.numbers.insert(c.numbers.end(), circulation.state().y.begin(), circulation.state().y.end());
  }
  c.evaluations = circulation.evaluations();
  return c;
}

TEST(OneNetwork, IsThatOfRankZeroToTheBit)
{
  const Communicator comm(MPI_COMM_WORLD);
  const Course expected = course(Communicator(MPI_COMM_SELF), 0.79);
  const Course found = course(comm, 0.79 + 0.1 * comm.rank());
  EXPECT_EQ(found.numbers, expected.numbers);
  EXPECT_EQ(found.evaluations, comm.is_rank_0() ? expected.evaluations : 0);
  EXPECT_GT(expected.evaluations, 40);
}

TEST(OneNetwork, ItsFailureIsThatOfAllRanks)
{
  const Communicator comm(MPI_COMM_WORLD);
  Circulation circulation(network(0.79), comm);
  const double flow = comm.is_rank_0() ? std::nan("") : 1.0;
  EXPECT_THROW(circulation.advance(kDt, {0, 0}, {0, flow}), SolverError);
}

TEST(OneNetwork, APeriodicStartIsThatOfRankZero)
{
  const Communicator comm(MPI_COMM_WORLD);
  const auto file = std::filesystem::path(VALSALVA_SOURCE_DIR) / "cases/healthy_adult/case.toml";
  const auto start_of = [&](const Communicator& ranks, double factor) {
    const setup::Case c = setup::read_case(
        file.string(), {"time.start=periodic", "surrogate.area_open_cm2=" + std::to_string(3 * factor)});
    const setup::NetworkStart start = setup::network_start(c, c.network, ranks);
    const Circulation circulation(start.spec, start.state, ranks);
    return std::pair(start.valve_load_mmHg, circulation.state());
  };
  const auto expected = start_of(Communicator(MPI_COMM_SELF), 1.0);
  const auto found = start_of(comm, 1.0 + 0.1 * comm.rank());
  EXPECT_GT(expected.first, 1.0);
  EXPECT_EQ(found.first, expected.first);
  EXPECT_EQ(found.second, expected.second);
}

}  // namespace
}  // namespace valsalva::coupling
