// The objects of the SUNDIALS C library (CVODES: Adams, functional iteration, roots, sensitivities in one
// system with the states) that one integrator needs, set up once and freed when it goes. Only
// cvode_integrator.cpp includes this.
#pragma once

#include <cvodes/cvodes.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

namespace valsalva::lumped {

struct SundialsFree {
  void operator()(_SUNContext* context) const { SUNContext_Free(&context); }
  void operator()(_generic_N_Vector* v) const { N_VDestroy(v); }
  void operator()(_generic_SUNNonlinearSolver* solver) const { SUNNonlinSolFree(solver); }
  void operator()(void* cvode) const { CVodeFree(&cvode); }
};

template <class T>
using SundialsPointer = std::unique_ptr<T, SundialsFree>;

/// What CVODE calls, and with which argument.
struct CvodeFunctions {
  CVRhsFn rates;
  CVRootFn margins;
  CVSensRhsFn tangents;
  CVErrHandlerFn message;
  void* user_data;
};

class CvodeMemory {
 public:
  /// `scale` per state and `direction_scale` per direction: absolute tolerance = rtol scale/direction_scale.
  CvodeMemory(std::vector<double> scale, std::vector<double> direction_scale, int roots,
              const CvodeFunctions& functions);

  /// Starts afresh at y(t); returns CVODE's flag. `S` may be null if there are no directions.
  int restart(double t, const std::vector<double>& y, const Eigen::MatrixXd* S, double rtol,
              double first_step, double stop);
  /// To `stop` or a root; returns CVODE's flag and the time reached, y and S there.
  int advance(double stop, double& t, std::vector<double>& y, Eigen::MatrixXd* S);

  void* cvode() const { return cvode_.get(); }

 private:
  void set_up_directions(const CvodeFunctions& functions);

  // In the order of creation; freed in the reverse order.
  std::vector<double> scale_, direction_scale_;
  SundialsPointer<_SUNContext> context_;
  SundialsPointer<_generic_N_Vector> y_, absolute_tolerance_;
  std::vector<SundialsPointer<_generic_N_Vector>> S_, S_tolerance_;
  std::vector<N_Vector> S_raw_, S_tolerance_raw_;
  SundialsPointer<_generic_SUNNonlinearSolver> fixed_point_, fixed_point_with_S_;
  SundialsPointer<void> cvode_;
};

}  // namespace valsalva::lumped
