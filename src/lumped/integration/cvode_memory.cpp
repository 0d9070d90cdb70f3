#include "lumped/integration/cvode_memory.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "common/error.hpp"
#include "lumped/integration/short_vector.hpp"

namespace valsalva::lumped {

namespace {

constexpr long kMostSteps = 200000;  // between two events or kinks; a heart beat takes a few hundred

/// For calls that only fail if this file is wrong or memory is out.
void require(bool success, const char* call)
{
  if (!success)
    throw SolverError(fmt::format("{} failed while the integrator of the lumped network was set up", call));
}

void fill(N_Vector v, const std::vector<double>& scale, double factor)
{
  std::transform(scale.begin(), scale.end(), N_VGetArrayPointer(v), [&](double s) { return factor * s; });
}

}  // namespace

CvodeMemory::CvodeMemory(std::vector<double> scale, std::vector<double> direction_scale, int roots,
                         const CvodeFunctions& functions)
    : scale_(std::move(scale)), direction_scale_(std::move(direction_scale))
{
  const auto count = static_cast<sunindextype>(scale_.size());
  SUNContext context = nullptr;
  require(SUNContext_Create(nullptr, &context) == 0, "SUNContext_Create");
  context_.reset(context);
  y_.reset(new_short_vector(count, context));
  absolute_tolerance_.reset(new_short_vector(count, context));
  cvode_.reset(CVodeCreate(CV_ADAMS, context));
  require(y_ && absolute_tolerance_ && cvode_, "CVodeCreate");
  N_VConst(0.0, y_.get());
  fill(absolute_tolerance_.get(), scale_, 1e-8);
  void* cvode = cvode_.get();
  require(CVodeInit(cvode, functions.rates, 0.0, y_.get()) == CV_SUCCESS, "CVodeInit");
  require(CVodeSVtolerances(cvode, 1e-8, absolute_tolerance_.get()) == CV_SUCCESS, "CVodeSVtolerances");
  fixed_point_.reset(SUNNonlinSol_FixedPoint(y_.get(), 0, context));
  require(fixed_point_ && CVodeSetNonlinearSolver(cvode, fixed_point_.get()) == CV_SUCCESS,
          "CVodeSetNonlinearSolver");
  require(CVodeSetUserData(cvode, functions.user_data) == CV_SUCCESS, "CVodeSetUserData");
  require(CVodeSetErrHandlerFn(cvode, functions.message, functions.user_data) == CV_SUCCESS,
          "CVodeSetErrHandlerFn");
  require(CVodeSetMaxNumSteps(cvode, kMostSteps) == CV_SUCCESS, "CVodeSetMaxNumSteps");
  if (roots > 0) {
    require(CVodeRootInit(cvode, roots, functions.margins) == CV_SUCCESS, "CVodeRootInit");
    std::vector<int> downward(static_cast<std::size_t>(roots), -1);
    require(CVodeSetRootDirection(cvode, downward.data()) == CV_SUCCESS, "CVodeSetRootDirection");
    require(CVodeSetNoInactiveRootWarn(cvode) == CV_SUCCESS, "CVodeSetNoInactiveRootWarn");
  }
  if (!direction_scale_.empty()) set_up_directions(functions);
}

void CvodeMemory::set_up_directions(const CvodeFunctions& functions)
{
  void* cvode = cvode_.get();
  for (std::size_t k = 0; k < direction_scale_.size(); ++k) {
    S_.emplace_back(N_VClone(y_.get()));
    S_tolerance_.emplace_back(N_VClone(y_.get()));
    require(S_.back() && S_tolerance_.back(), "N_VClone");
    N_VConst(0.0, S_.back().get());
    S_raw_.push_back(S_.back().get());
    S_tolerance_raw_.push_back(S_tolerance_.back().get());
  }
  const int count = static_cast<int>(S_.size());
  require(CVodeSensInit(cvode, count, CV_SIMULTANEOUS, functions.tangents, S_raw_.data()) == CV_SUCCESS,
          "CVodeSensInit");
  require(CVodeSetSensErrCon(cvode, SUNTRUE) == CV_SUCCESS, "CVodeSetSensErrCon");
  fixed_point_with_S_.reset(SUNNonlinSol_FixedPointSens(count + 1, y_.get(), 0, context_.get()));
  require(
      fixed_point_with_S_ && CVodeSetNonlinearSolverSensSim(cvode, fixed_point_with_S_.get()) == CV_SUCCESS,
      "CVodeSetNonlinearSolverSensSim");
}

int CvodeMemory::restart(double t, const std::vector<double>& y, const Eigen::MatrixXd* S, double rtol,
                         double first_step, double stop)
{
  void* cvode = cvode_.get();
  std::copy(y.begin(), y.end(), N_VGetArrayPointer(y_.get()));
  fill(absolute_tolerance_.get(), scale_, rtol);
  int flag = CVodeReInit(cvode, t, y_.get());
  if (flag == CV_SUCCESS) flag = CVodeSVtolerances(cvode, rtol, absolute_tolerance_.get());
  for (std::size_t k = 0; k < S_.size(); ++k) {
    const double* column = S->col(static_cast<Eigen::Index>(k)).data();
    std::copy(column, column + y.size(), N_VGetArrayPointer(S_raw_[k]));
    fill(S_tolerance_raw_[k], scale_, rtol / direction_scale_[k]);
  }
  if (!S_.empty()) {
    if (flag == CV_SUCCESS) flag = CVodeSensReInit(cvode, CV_SIMULTANEOUS, S_raw_.data());
    if (flag == CV_SUCCESS) flag = CVodeSensSVtolerances(cvode, rtol, S_tolerance_raw_.data());
  }
  if (flag == CV_SUCCESS) flag = CVodeSetInitStep(cvode, first_step);
  if (flag == CV_SUCCESS) flag = CVodeSetStopTime(cvode, stop);
  return flag;
}

int CvodeMemory::advance(double stop, double& t, std::vector<double>& y, Eigen::MatrixXd* S)
{
  const int flag = CVode(cvode_.get(), stop, y_.get(), &t, CV_NORMAL);
  if (flag < 0) return flag;
  std::copy(N_VGetArrayPointer(y_.get()), N_VGetArrayPointer(y_.get()) + y.size(), y.begin());
  if (S_.empty()) return flag;
  double reached = t;
  const int sensitivity_flag = CVodeGetSens(cvode_.get(), &reached, S_raw_.data());
  for (std::size_t k = 0; k < S_.size(); ++k)
    std::copy(N_VGetArrayPointer(S_raw_[k]), N_VGetArrayPointer(S_raw_[k]) + y.size(),
              S->col(static_cast<Eigen::Index>(k)).data());
  return sensitivity_flag < 0 ? sensitivity_flag : flag;
}

}  // namespace valsalva::lumped
