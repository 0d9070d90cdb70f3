// A small tangle of springs (some slack, some tension-only), beams on uneven sides and tethers, for tests of
// identities that hold for every network. Lengths and stiffnesses of order 1.
#pragma once

#include <random>
#include <vector>

#include "ib3d/structure/fibres/fibre_network.hpp"

namespace valsalva::ib3d {

inline std::vector<Vec3> random_vectors(int count, unsigned seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<Vec3> v(static_cast<std::size_t>(count));
  for (Vec3& x : v) x = {uniform(generator), uniform(generator), uniform(generator)};
  return v;
}

inline FibreNetwork random_network(int nodes, unsigned seed)
{
  std::mt19937 generator(seed);
  std::uniform_int_distribution<int> node(0, nodes - 1);
  std::uniform_real_distribution<double> uniform(0.5, 1.5);
  FibreNetwork network;
  network.X = random_vectors(nodes, seed + 1);
  for (int n = 0; n < 4 * nodes; ++n) {
    const int a = node(generator), b = (a + 1 + n % (nodes - 1)) % nodes;
    const double stiffness = uniform(generator), rest_length = uniform(generator);
    network.springs.add(a, b, stiffness, rest_length, n % 2 == 0);
  }
  for (int n = 0; n < nodes; ++n) {
    const double rigidity = uniform(generator), l1 = uniform(generator), l2 = uniform(generator);
    network.beams.add({n, (n + 1) % nodes, (n + 2) % nodes}, rigidity, l1, l2);
  }
  for (int n = 0; n < nodes; n += 2)
    network.tethers.add(n, uniform(generator), random_vectors(1, seed + 2 + static_cast<unsigned>(n))[0]);
  return network;
}

}  // namespace valsalva::ib3d
