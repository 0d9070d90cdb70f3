// A straight tube of fluid without friction between a pressure source and a Windkessel: plug flow, so that the
// coupled model is exactly the linear system
//     L dQ/dt = p_in - Pc - Rc Q,   C dPc/dt = Q - Pc/Rp,   L = rho l/A.
// mmHg, ml, s.
#pragma once

#include <Eigen/Dense>
#include <unsupported/Eigen/MatrixFunctions>

#include "common/units.hpp"
#include "coupling/coupled_model.hpp"
#include "ib3d/fluid/tube.hpp"
#include "ib3d/structure/fibres/fibre_model.hpp"
#include "lumped/specs.hpp"

namespace valsalva::coupling {

struct TubeLoad {
  double Rc = 0.05, Rp = 1.0, C = 0.2, p_in = 1.0;
};

inline const Vec3 kTubeSize{1, 1, 2};
inline constexpr double kTubeInertance = 1.06 * 2 / common::kMmHg;

inline lumped::NetworkSpec tube_network(const TubeLoad& load)
{
  return {{lumped::testing::pressure_source("source", "lv", load.p_in),
           lumped::testing::windkessel("arteries", "ao", load.Rc, load.Rp, load.C, 0.0)},
          {"lv", "ao"},
          0.0};
}

struct TubeModel {
  TubeModel(const lumped::NetworkSpec& network, CouplingScheme scheme, const StepControl& control)
      : circulation(network, Communicator(MPI_COMM_SELF)),
        grid(ib3d::walled_box(kTubeSize), kTubeSize[0] / 8, MPI_COMM_SELF),
        root(grid, ib3d::both_ends(kTubeSize), {1.06, 0.0, ib3d::Advection::none}, {"multilevel", 1e-10, 50},
             std::make_unique<ib3d::FibreModel>(ib3d::FibreNetwork{}), ib3d::StructureScheme::leapfrog,
             timers),
        model(root, circulation, scheme, control, timers)
  {
  }
  double flow() const { return model.interface().flow_ml_s[1]; }

  Timers timers;
  Circulation circulation;
  ib3d::Hierarchy grid;
  ib3d::ImmersedBoundarySolver root;
  CoupledModel model;
};

inline TubeModel tube_with_fixed_step(const TubeLoad& load, CouplingScheme scheme, double dt)
{
  StepControl control;
  control.dt_fixed_s = dt;
  return {tube_network(load), scheme, control};
}

/// (Q, Pc) of the linear system at time t, from rest.
inline Eigen::Vector2d exact_tube(const TubeLoad& load, double t)
{
  const double L = kTubeInertance;
  Eigen::Matrix2d A;
  A << -load.Rc / L, -1 / L, 1 / load.C, -1 / (load.Rp * load.C);
  const Eigen::Vector2d b(load.p_in / L, 0);
  return A.lu().solve((Eigen::Matrix2d((A * t).exp()) - Eigen::Matrix2d::Identity()) * b);
}

}  // namespace valsalva::coupling
