#include "lumped/network/nodal_circuit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace valsalva::lumped {

TEST(NodalCircuit, AnIsolatedNodeHasItsTheveninPressure)
{
  NodalCircuit<double> circuit(2);
  circuit.hold_pressure(0, 70.0);
  circuit.add_inflow(0, 12.0);
  circuit.add_pressure(1, 85.0, 0.033);
  circuit.add_inflow(1, 300.0);
  circuit.solve();
  EXPECT_EQ(circuit.pressure(0), 70.0);
  EXPECT_EQ(circuit.flow_into_holder(0), 12.0);
  EXPECT_NEAR(circuit.pressure(1), 85.0 + 0.033 * 300.0, 1e-12);
}

TEST(NodalCircuit, CoupledQuadraticResistorsSatisfyKirchhoffAtEveryNode)
{
  // 0 is held; 1, 2, 3 stand behind resistances; resistors 0-1, 1-2, 1-3, 3-0, some with jets, some driven
  // backwards.
  struct Branch {
    int from, to;
    double R, B;
  };
  const Branch branches[] = {{0, 1, 0.01, 3e-5}, {1, 2, 0.0, 1e-3}, {1, 3, 0.02, 0.0}, {3, 0, 0.005, 2e-4}};
  const double behind[] = {0.0, 80.0, 20.0, 130.0}, R[] = {0.0, 0.05, 0.3, 0.04},
               given[] = {5.0, -40.0, 0.0, 25.0};
  NodalCircuit<double> circuit(4);
  circuit.hold_pressure(0, 110.0);
  for (int n = 0; n < 4; ++n) circuit.add_inflow(n, given[n]);
  for (int n = 1; n < 4; ++n) circuit.add_pressure(n, behind[n], R[n]);
  for (const Branch& b : branches) circuit.add_resistor(b.from, b.to, b.R, b.B);
  circuit.solve();
  double balance[4];
  for (int n = 0; n < 4; ++n)
    balance[n] = given[n] + (n > 0 ? (behind[n] - circuit.pressure(n)) / R[n] : 0.0);
  for (const Branch& b : branches) {
    const double Q = resistor_flow(circuit.pressure(b.from) - circuit.pressure(b.to), b.R, b.B);
    balance[b.from] -= Q;
    balance[b.to] += Q;
  }
  EXPECT_NEAR(balance[0], circuit.flow_into_holder(0), 1e-9);
  for (int n = 1; n < 4; ++n) EXPECT_NEAR(balance[n], 0.0, 1e-9) << "node " << n;
}

TEST(NodalCircuit, ResistorFlowSolvesItsQuadraticForBothSigns)
{
  for (double dp : {-40.0, -1e-9, 0.0, 1e-9, 3.0})
    for (double B : {0.0, 1e-5, 10.0}) {
      const double Q = resistor_flow(dp, 0.01, B);
      EXPECT_NEAR(0.01 * Q + B * Q * std::abs(Q), dp, 1e-14 + 1e-13 * std::abs(dp));
    }
}

}  // namespace valsalva::lumped
