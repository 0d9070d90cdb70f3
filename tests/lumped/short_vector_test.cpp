// The integrator's own vector arithmetic against that of SUNDIALS, at lengths with and without a remainder.
#include "lumped/integration/short_vector.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace valsalva::lumped::testing {

namespace {

using Vector = std::unique_ptr<_generic_N_Vector, decltype(&N_VDestroy)>;

void expect_equal(const Vector& own, const Vector& library)
{
  for (sunindextype i = 0; i < NV_LENGTH_S(own.get()); ++i)
    EXPECT_DOUBLE_EQ(NV_Ith_S(own.get(), i), NV_Ith_S(library.get(), i)) << "entry " << i;
}

}  // namespace

TEST(ShortVector, ComputesWhatTheVectorOfSundialsComputes)
{
  SUNContext context = nullptr;
  ASSERT_EQ(SUNContext_Create(nullptr, &context), 0);
  for (const sunindextype count : {1, 2, 3, 7, 12, 24, 25, 61}) {
    const Vector x(new_short_vector(count, context), N_VDestroy), y(N_VClone(x.get()), N_VDestroy);
    const Vector X(N_VNew_Serial(count, context), N_VDestroy), Y(N_VClone(X.get()), N_VDestroy);
    EXPECT_EQ(y->ops->nvlinearsum, x->ops->nvlinearsum) << "a clone is of the same kind";
    EXPECT_NE(x->ops->nvlinearsum, X->ops->nvlinearsum);
    for (sunindextype i = 0; i < count; ++i)
      NV_Ith_S(x.get(), i) = NV_Ith_S(X.get(), i) = 0.5 + 0.25 * static_cast<double>(i * i % 17);
    N_VConst(-3.0, y.get()), N_VConst(-3.0, Y.get());
    N_VLinearSum(2.0, x.get(), 0.5, y.get(), y.get());
    N_VLinearSum(2.0, X.get(), 0.5, Y.get(), Y.get());
    expect_equal(y, Y);
    N_VScale(-0.75, y.get(), y.get()), N_VScale(-0.75, Y.get(), Y.get());
    expect_equal(y, Y);
    double factors[] = {0.5, -0.25};
    N_Vector own[] = {x.get(), y.get()}, library[] = {X.get(), Y.get()};
    N_VScaleAddMulti(2, factors, x.get(), own, own), N_VScaleAddMulti(2, factors, X.get(), library, library);
    expect_equal(x, X), expect_equal(y, Y);
    N_VScaleVectorArray(2, factors, own, own), N_VScaleVectorArray(2, factors, library, library);
    expect_equal(x, X), expect_equal(y, Y);
    N_VAbs(y.get(), y.get()), N_VAbs(Y.get(), Y.get());
    expect_equal(y, Y);
    N_VInv(x.get(), x.get()), N_VInv(X.get(), X.get());
    expect_equal(x, X);
    EXPECT_NEAR(N_VWrmsNorm(y.get(), x.get()) / N_VWrmsNorm(Y.get(), X.get()), 1.0, 1e-14);
  }
  SUNContext_Free(&context);
}

}  // namespace valsalva::lumped::testing
