// What every elastic model promises: force, energy and stiffness belong together, and parts are exact. For finite elements;
// those of fibres are in fibre_force_test and fibre_model_test.
#include <gtest/gtest.h>

#include "common/max_or_nan.hpp"
#include "random_network.hpp"
#include "triangle_model.hpp"

namespace valsalva::ib3d {
namespace {

std::vector<Vec3> force(const ElasticModel& model, const std::vector<Vec3>& X)
{
  std::vector<Vec3> F(X.size(), Vec3{0, 0, 0});
  model.add_force(X, F);
  return F;
}

TEST(ElasticModel, ForceAndStiffnessAreTheGradientsOfTheEnergy)
{
  const auto model = stretched_sheet({1, 1, 1}, 1, 6, 1.2);
  const std::vector<Vec3>& X = model->start();
  const std::vector<Vec3> F = force(*model, X), v = random_vectors(model->node_count(), 5);
  const double step = 1e-5;
  std::vector<Vec3> ahead = X, behind = X, Kv(X.size(), Vec3{0, 0, 0});
  double power = 0;
  for (std::size_t n = 0; n < X.size(); ++n) {
    ahead[n] += step * v[n];
    behind[n] -= step * v[n];
    power += dot(F[n], v[n]);
  }
  EXPECT_GT(std::abs(power), 1.0);
  EXPECT_NEAR(-(model->energy(ahead) - model->energy(behind)) / (2 * step), power, 1e-6 * std::abs(power));
  model->add_stiffness_times(X, v, Kv);
  const std::vector<Vec3> above = force(*model, ahead), below = force(*model, behind);
  for (std::size_t n = 0; n < X.size(); ++n)
    EXPECT_LT(norm(Kv[n] + (0.5 / step) * (above[n] - below[n])), 1e-6 * max_or_nan(Kv, common::norm));
}

TEST(ElasticModel, ElementsThatTouchTheOwnedNodesMakeTheirForcesComplete)
{
  const auto whole = stretched_sheet({1, 1, 1}, 1, 8, 1.2);
  const std::vector<Vec3> F = force(*whole, whole->start());
  std::vector<int> owned;
  for (int n = whole->node_count() - 1; n >= 0; n -= 3) owned.push_back(n);
  const Selection s = touching(whole->elements(), whole->node_count(), owned);
  EXPECT_LT(static_cast<int>(s.elements.size()), whole->elements().count());
  const auto part = whole->part(s);
  const std::vector<Vec3> of_part = force(*part, part->start());
  for (std::size_t i = 0; i < owned.size(); ++i)
    EXPECT_EQ(of_part[i], F[static_cast<std::size_t>(owned[i])]) << owned[i];
}

}  // namespace
}  // namespace valsalva::ib3d
