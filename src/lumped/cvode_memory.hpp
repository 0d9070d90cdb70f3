// The objects of the SUNDIALS C library that one integrator needs, freed when it goes. Only
// cvode_integrator.cpp includes this.
#pragma once

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <memory>
#include <string>

namespace valsalva::lumped {

struct SundialsFree {
  void operator()(_SUNContext* context) const { SUNContext_Free(&context); }
  void operator()(_generic_N_Vector* v) const { N_VDestroy(v); }
  void operator()(_generic_SUNNonlinearSolver* solver) const { SUNNonlinSolFree(solver); }
  void operator()(void* cvode) const { CVodeFree(&cvode); }
};

template <class T>
using SundialsPointer = std::unique_ptr<T, SundialsFree>;

/// In the order of creation; freed in the reverse order.
struct CvodeMemory {
  SundialsPointer<_SUNContext> context;
  SundialsPointer<_generic_N_Vector> y;
  SundialsPointer<_generic_N_Vector> absolute_tolerance;
  SundialsPointer<_generic_SUNNonlinearSolver> fixed_point;
  SundialsPointer<void> cvode;
  std::string message;  ///< what CVODE last complained of
};

}  // namespace valsalva::lumped
