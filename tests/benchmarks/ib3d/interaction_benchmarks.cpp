// Cost of spreading and interpolating per node: a tube in the box of cases/aortic_root at h = 10/96, with the three layers of
// the root's wall, nodes in the order of NodeDistribution. Between two calls the caches see as much memory as in a step.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "ib3d/fluid/grids.hpp"
#include "ib3d/interaction/spread_interpolate.hpp"

namespace valsalva::ib3d {
namespace {

struct TubeOfNodes {
  TubeOfNodes()
  {
    const double h = level().h, spacing = 0.6 * h, radius = 1.3;
    const int around = static_cast<int>(2 * M_PI * radius / spacing);
    for (double z = 1; z < 14; z += spacing)
      for (int i = 0; i < around; ++i)
        for (double r : {radius, radius + 0.5 * h, radius + h}) {
          const double a = 2 * M_PI * i / around;
          X.push_back({2.5 + r * std::cos(a), 2.5 + r * std::sin(a), z});
        }
    const auto cell = [h](const Vec3& x) {
      return std::tuple(std::floor(x[2] / h), std::floor(x[1] / h), std::floor(x[0] / h));
    };
    std::sort(X.begin(), X.end(), [&](const Vec3& a, const Vec3& b) { return cell(a) < cell(b); });
    F.assign(X.size(), Vec3{1, -2, 0.5});
    first = {0, static_cast<int>(X.size())};
  }
  const Level& level() const { return grid.finest(); }
  Hierarchy grid = nested_grid(walled_box({5, 5, 15}), 10.0 / 96, 1);
  std::vector<Vec3> X, F;
  std::vector<int> first;
};

benchmark::Counter each_node(const TubeOfNodes& tube)
{
  return benchmark::Counter(static_cast<double>(tube.X.size()),
                            benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// What the rest of a step leaves of the caches.
void other_work(benchmark::State& state)
{
  static std::vector<double> fields(4'000'000);
  state.PauseTiming();
  for (double& x : fields) x += 1;
  benchmark::DoNotOptimize(fields.data());
  state.ResumeTiming();
}

void spread(benchmark::State& state)
{
  const TubeOfNodes tube;
  const Interaction interaction(tube.level());
  MacField f(tube.level());
  for (auto _ : state) {
    other_work(state);
    interaction.spread(tube.first, tube.X, tube.F, f);
  }
  state.counters["per_node"] = each_node(tube);
}
BENCHMARK(spread)->Unit(benchmark::kMillisecond);

void interpolate(benchmark::State& state)
{
  TubeOfNodes tube;
  const Interaction interaction(tube.level());
  const MacField u(tube.level());
  for (auto _ : state) {
    other_work(state);
    interaction.interpolate(tube.first, tube.X, u, tube.F);
  }
  state.counters["per_node"] = each_node(tube);
}
BENCHMARK(interpolate)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace valsalva::ib3d
