// Time of one heart beat of 0D networks at rtol 1e-8: plain, with sensitivities, and the whole way to a periodic
// state. `plain_cvode` is a bare C program for the same Windkessel, the yardstick of the machine: it took 0.05 ms
// where the limits of 0.06 ms (Windkessel) and 1.5 ms (twelve states) were set. Build the target lumped_benchmark,
// run build/release/tests/lumped_benchmark.
#include <benchmark/benchmark.h>
#include <cvodes/cvodes.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <cmath>
#include <numbers>

#include "lumped/integration/limit_cycle.hpp"
#include "lumped/specs.hpp"

namespace valsalva::lumped::testing {

namespace {

NetworkSpec driven_windkessel()
{
  return {
      {{"heart",
        "flow_source",
        {{"node", "ao"}},
        {},
        {{"flow_ml_s", {95.0}}, {"cosine_ml_s", {40.0, -80.0, -20.0}}, {"sine_ml_s", {150.0, 60.0, -25.0}}},
        {}},
       windkessel("arteries", "ao")},
      {},
      0.8};
}

constexpr int kBeats = 20;

/// Twenty beats in one go; items per second are beats per second.
void beat(benchmark::State& timing, const NetworkSpec& spec)
{
  const LumpedNetwork network(spec);
  CvodeIntegrator integrator(network);
  const LumpedState start = find_limit_cycle(spec).start;
  for ([[maybe_unused]] auto _ : timing) {
    LumpedState state = start;
    integrator.advance(state, start.t + kBeats * spec.period_s, {}, {});
    benchmark::DoNotOptimize(state.y.data());
  }
  timing.SetItemsProcessed(timing.iterations() * kBeats);
}

int plain_rates(double t, N_Vector y, N_Vector dydt, void*)
{
  const double w = 2.0 * std::numbers::pi / 0.8;
  const double Q = 95.0 + 40.0 * std::cos(w * t) - 80.0 * std::cos(2.0 * w * t) -
                   20.0 * std::cos(3.0 * w * t) + 150.0 * std::sin(w * t) + 60.0 * std::sin(2.0 * w * t) -
                   25.0 * std::sin(3.0 * w * t);
  NV_Ith_S(dydt, 0) = (Q - NV_Ith_S(y, 0) / 0.79) / 1.75;
  return 0;
}

void plain_cvode(benchmark::State& timing)
{
  SUNContext context;
  SUNContext_Create(nullptr, &context);
  N_Vector y = N_VNew_Serial(1, context);
  N_VConst(85.0, y);
  void* cvode = CVodeCreate(CV_ADAMS, context);
  CVodeInit(cvode, plain_rates, 0.0, y);
  CVodeSStolerances(cvode, 1e-8, 1e-8);
  SUNNonlinearSolver fixed_point = SUNNonlinSol_FixedPoint(y, 0, context);
  CVodeSetNonlinearSolver(cvode, fixed_point);
  CVodeSetMaxNumSteps(cvode, 1000000);
  for ([[maybe_unused]] auto _ : timing) {
    N_VConst(85.0, y);
    CVodeReInit(cvode, 0.0, y);
    double t = 0.0;
    CVode(cvode, kBeats * 0.8, y, &t, CV_NORMAL);
  }
  timing.SetItemsProcessed(timing.iterations() * kBeats);
  CVodeFree(&cvode);
  SUNNonlinSolFree(fixed_point);
  N_VDestroy(y);
  SUNContext_Free(&context);
}

void beat_with_eight_sensitivities(benchmark::State& timing, const NetworkSpec& spec,
                                   const std::vector<std::string>& parameters)
{
  const LumpedNetwork network(spec);
  Tangents tangents(spec, parameters);
  CvodeIntegrator integrator(network, tangents);
  const LumpedState start = find_limit_cycle(spec).start;
  for ([[maybe_unused]] auto _ : timing) {
    LumpedState state = start;
    Eigen::MatrixXd S = tangents.initial();
    integrator.advance(state, S, start.t + spec.period_s);
    benchmark::DoNotOptimize(S.data());
  }
}

void periodic_state(benchmark::State& timing, const NetworkSpec& spec)
{
  for ([[maybe_unused]] auto _ : timing) benchmark::DoNotOptimize(find_limit_cycle(spec).newton_steps);
}

BENCHMARK(plain_cvode)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(beat, windkessel, driven_windkessel())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(beat, left_heart, left_heart())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(beat, four_chambers_12_states, four_chambers())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(beat_with_eight_sensitivities, four_chambers_12_states, four_chambers(),
                  {"body.R_mmHg_s_ml", "body.C_ml_mmHg", "aorta.C_ml_mmHg", "lungs.R_mmHg_s_ml",
                   "lv.Emax_mmHg_ml", "lv.Emin_mmHg_ml", "aortic.R_mmHg_s_ml", "lv.initial_volume_ml"})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(periodic_state, left_heart, left_heart())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(periodic_state, four_chambers_12_states, four_chambers())->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace valsalva::lumped::testing

BENCHMARK_MAIN();
