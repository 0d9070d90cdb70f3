#include "ib3d/structure/fibres/fibre_files.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "complaint.hpp"
#include "ib3d/structure/fibres/fibre_force.hpp"
#include "random_network.hpp"

namespace valsalva::ib3d {
namespace {

class FibreFiles : public ::testing::Test {
 protected:
  void SetUp() override
  {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() / (std::string("valsalva_fibers_") + test->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    prefix_ = (folder_ / "net").string();
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& ending, const std::string& text) { std::ofstream(prefix_ + ending) << text; }

  /// The message that reading ends with.
  std::string refusal() const
  {
    return complaint([&] { read_fibre_files(prefix_); });
  }

  std::filesystem::path folder_;
  std::string prefix_;
};

using ::testing::Test;

TEST_F(FibreFiles, RoundTripKeepsTheForces)
{
  FibreNetwork network = random_network(15, 31);
  for (std::size_t n = 0; n < network.tethers.node.size(); ++n)
    network.tethers.target[n] = network.X[static_cast<std::size_t>(network.tethers.node[n])];
  write_fibre_files(network, prefix_);
  const FibreNetwork again = read_fibre_files(prefix_);
  EXPECT_EQ(again.X, network.X);
  EXPECT_EQ(again.springs.a, network.springs.a);
  EXPECT_EQ(again.springs.tension_only, network.springs.tension_only);
  EXPECT_EQ(again.beams.l1, network.beams.l1);
  const std::vector<Vec3> X = random_vectors(15, 32);
  std::vector<Vec3> F(X.size()), F_again(X.size());
  add_fibre_force(network, X, F);
  add_fibre_force(again, X, F_again);
  for (std::size_t i = 0; i < X.size(); ++i) EXPECT_LT(norm(F[i] - F_again[i]), 1e-12 * norm(F[i]));
}

TEST_F(FibreFiles, SpringPullsWithStiffnessTimesLengthening)
{
  write(".vertex", "2  # two nodes\n0 0 0\n3 0 0 // the second\n");
  write(".spring", "2\n0 1 5.0 2.0\n\n0 1 7.0 0.0\n");
  const FibreNetwork network = read_fibre_files(prefix_);
  std::vector<Vec3> F(2);
  add_fibre_force(network, network.X, F);
  EXPECT_NEAR(F[0][0], 5.0 * (3.0 - 2.0) + 7.0 * 3.0, 1e-7);
}

TEST_F(FibreFiles, BeamForceIsTheSecondDifferenceOnAnySpacing)
{
  write(".vertex", "3\n0 0 0\n1 0 0\n3 1 0\n");
  write(".beam", "1\n0 1 2 2.5\n");
  const FibreNetwork network = read_fibre_files(prefix_);
  std::vector<Vec3> F(3);
  add_fibre_force(network, network.X, F);
  const Vec3 second = network.X[2] - 2.0 * network.X[1] + network.X[0];
  EXPECT_LT(norm(F[1] - 5.0 * second), 1e-12);
  EXPECT_LT(norm(F[0] + 2.5 * second), 1e-12);
  EXPECT_LT(norm(F[2] + 2.5 * second), 1e-12);
}

TEST_F(FibreFiles, TargetHoldsTheNodeAtItsStart)
{
  write(".vertex", "2\n0 0 0\n1 2 3\n");
  write(".target", "1\n1 4.0 0.0\n");
  const FibreNetwork network = read_fibre_files(prefix_);
  EXPECT_EQ(network.tethers.target[0], (Vec3{1.0, 2.0, 3.0}));
  std::vector<Vec3> X = network.X, F(2);
  X[1][2] = 3.5;
  add_fibre_force(network, X, F);
  EXPECT_DOUBLE_EQ(F[1][2], -2.0);
}

TEST_F(FibreFiles, VerticesAloneAreEnough)
{
  write(".vertex", "1\n0 0 0\n");
  const FibreNetwork network = read_fibre_files(prefix_);
  EXPECT_EQ(network.springs.count() + network.beams.count() + network.tethers.count(), 0);
  EXPECT_EQ(network.groups.front().name, "net");
}

TEST_F(FibreFiles, MissingVertexFileIsAnIoError)
{
  EXPECT_THROW(read_fibre_files(prefix_), IoError);
}

TEST_F(FibreFiles, TargetAwayFromTheStartCannotBeWritten)
{
  EXPECT_THROW(write_fibre_files(random_network(5, 33), prefix_), IoError);
}

TEST_F(FibreFiles, ComplainsWithFileLineAndReason)
{
  const std::string good = "3\n0 0 0\n1 0 0\n2 0 0\n";
  struct Bad {
    const char *ending, *text, *expected;
  };
  for (const Bad& bad : {
           Bad{".vertex", "3\n0 0 0\n1 0 0\n", "net.vertex:1:1: 3 lines are announced, but 2 follow"},
           Bad{".vertex", "1\n0 0 0\n# comment\n1 0 0\n", "net.vertex:4:1: found more than the 1 lines"},
           Bad{".vertex", "1\n0 0\n", "net.vertex:2:1: found 2 entries, but a line must read: x y z"},
           Bad{".vertex", "1\n0 0 x\n", "net.vertex:2:1: \"x\" is not a finite number"},
           Bad{".vertex", "", "net.vertex:1:1: the file is empty"},
           Bad{".vertex", "0 0 0\n", "the first line must be the number of lines"},
           Bad{".spring", "1\n0 3 1 1\n", "net.spring:2:1: found node 3, but nodes are numbered 0 to 2"},
           Bad{".spring", "1\n0 0.5 1 1\n", "net.spring:2:1: found node 0.5"},
           Bad{".spring", "1\n1 1 1 1\n", "net.spring:2:1: a spring cannot join node 1 to itself"},
           Bad{".spring", "1\n0 1 -1 1\n", "net.spring:2:1: found a stiffness of -1"},
           Bad{".spring", "1\n0 1 1 1 7\n", "net.spring:2:1: found spring type 7"},
           Bad{".beam", "1\n0 1 2 1 0.5 0 0\n", "net.beam:2:1: a preferred curvature"},
           Bad{".beam", "1\n0 1 0 1\n", "net.beam:2:1: a beam needs three different nodes"},
           Bad{".target", "1\n0 1 0.1\n", "net.target:2:1: damping"},
       }) {
    write(".vertex", good);
    for (const char* ending : {".spring", ".beam", ".target"}) std::filesystem::remove(prefix_ + ending);
    write(bad.ending, bad.text);
    EXPECT_NE(refusal().find(bad.expected), std::string::npos) << "got: " << refusal();
  }
}

TEST_F(FibreFiles, EveryWrongFileIsNamedAtOnce)
{
  write(".vertex", "2\n0 0 0\n1 0 0\n");
  write(".spring", "1\n0 9 1 1\n");
  write(".target", "1\n9 1\n");
  const std::string message = refusal();
  EXPECT_NE(message.find("net.spring:2"), std::string::npos);
  EXPECT_NE(message.find("net.target:2"), std::string::npos);
}

}  // namespace
}  // namespace valsalva::ib3d
