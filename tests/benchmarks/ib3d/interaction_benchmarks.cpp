// Cost of spreading and interpolating per node: a tube of nodes half a cell apart, as dense as the root's wall.
#include <benchmark/benchmark.h>

#include <cmath>

#include "ib3d/fluid/grids.hpp"
#include "ib3d/interaction/spread_interpolate.hpp"

namespace valsalva::ib3d {
namespace {

struct TubeOfNodes {
  TubeOfNodes()
  {
    const double h = level().h, radius = 1.3;
    const int around = static_cast<int>(2 * M_PI * radius / (0.5 * h));
    for (double z = 1; z < 14; z += 0.5 * h)
      for (int i = 0; i < around; ++i) {
        const double a = 2 * M_PI * i / around;
        X.push_back({5 + radius * std::cos(a), 5 + radius * std::sin(a), z});
      }
    F.assign(X.size(), Vec3{1, -2, 0.5});
    first = {0, static_cast<int>(X.size())};
  }
  const Level& level() const { return grid.finest(); }
  Hierarchy grid = nested_grid(walled_box({10, 10, 15}), 10.0 / 128, 1);
  std::vector<Vec3> X, F;
  std::vector<int> first;
};

benchmark::Counter each_node(const TubeOfNodes& tube)
{
  return benchmark::Counter(static_cast<double>(tube.X.size()),
                            benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void spread(benchmark::State& state)
{
  const TubeOfNodes tube;
  const Interaction interaction(tube.level());
  MacField f(tube.level());
  for (auto _ : state) interaction.spread(tube.first, tube.X, tube.F, f);
  state.counters["per_node"] = each_node(tube);
}
BENCHMARK(spread)->Unit(benchmark::kMillisecond);

void interpolate(benchmark::State& state)
{
  TubeOfNodes tube;
  const Interaction interaction(tube.level());
  const MacField u(tube.level());
  for (auto _ : state) interaction.interpolate(tube.first, tube.X, u, tube.F);
  state.counters["per_node"] = each_node(tube);
}
BENCHMARK(interpolate)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace valsalva::ib3d
