// Time of one heart beat of 0D networks at rtol 1e-8: plain, with sensitivities, and the whole way to a periodic
// state. Run with  build/release/tests/lumped_benchmark
#include <benchmark/benchmark.h>

#include "lumped/limit_cycle.hpp"
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

/// Beat after beat from the periodic state.
void beat(benchmark::State& timing, const NetworkSpec& spec)
{
  const LumpedNetwork network(spec);
  CvodeIntegrator integrator(network);
  const LumpedState start = find_limit_cycle(spec).start;
  for (auto _ : timing) {
    LumpedState state = start;
    integrator.advance(state, start.t + spec.period_s, {}, {});
    benchmark::DoNotOptimize(state.y.data());
  }
}

void beat_with_eight_sensitivities(benchmark::State& timing, const NetworkSpec& spec,
                                   const std::vector<std::string>& parameters)
{
  const LumpedNetwork network(spec);
  Tangents tangents(spec, parameters);
  CvodeIntegrator integrator(network, tangents);
  const LumpedState start = find_limit_cycle(spec).start;
  for (auto _ : timing) {
    LumpedState state = start;
    Eigen::MatrixXd S = tangents.initial();
    integrator.advance(state, S, start.t + spec.period_s);
    benchmark::DoNotOptimize(S.data());
  }
}

void periodic_state(benchmark::State& timing, const NetworkSpec& spec)
{
  for (auto _ : timing) benchmark::DoNotOptimize(find_limit_cycle(spec).newton_steps);
}

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
