// A case as plain values: what `read_case` makes of a TOML file, and all that the rest of the program sees of it. The
// members' initialisers are the defaults of the keys; the key tables (keys_*.cpp) hold ranges and meanings. Units as
// the names say, CGS inside the structs of ib3d, mmHg, ml and s inside those of lumped.
#pragma once

#include <array>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "casefile/case_file.hpp"
#include "coupling/coupled_model.hpp"
#include "ib3d/grid/refinement.hpp"
#include "ib3d/structure/aortic_root/root_parameters.hpp"
#include "lumped/fit/fit_problem.hpp"

namespace valsalva::setup {

enum class Start { rest, periodic };

struct Time {
  double end_s = 0;
  double period_s = 0;                   ///< of a beat; 0: the whole run is one beat
  double stop_when_periodic_within = 0;  ///< largest relative change from beat to beat; 0: run to end_s
  Start start = Start::rest;             ///< of the network
  coupling::StepControl steps;

  /// Length of a beat, s.
  double beat_s() const { return period_s > 0 ? period_s : end_s; }
};

struct Grid {
  double finest_cm = 0.104167;
  ib3d::RefinementPolicy refinement;  ///< with the regions of [[refine]] only
};

/// A region of [[refine]].
struct Refine {
  std::string name;
  ib3d::RefinedRegion region;
};

enum class StructureKind { none, aortic_root, files };

struct Structure {
  StructureKind kind = StructureKind::none;
  ib3d::StructureScheme scheme = ib3d::StructureScheme::leapfrog;
  double fold_relaxation_s = 0;
  std::string files_prefix;  ///< relative to the case
  ib3d::RootDimensions root;
  ib3d::LeafletMaterial leaflets;  ///< but for edge_tether_ratio, which follows from the next member
  double edge_tether_dyn_cm3 = 8e7;
  std::array<ib3d::LeafletFactors, 3> factors;
  ib3d::WallMaterial wall;
};

/// Passive markers that are released in discs across z.
struct MarkerGroup {
  std::string name;
  std::vector<double> z_cm;
  double spacing_cm = 0.1;
  double radius_cm = 0;  ///< 0: the lumen of the aortic root, else of the narrowest opening
  std::optional<std::array<double, 2>> centre_cm;  ///< else the axis of the root
  double start_s = 0;
  double every_s = 0;  ///< 0: once
  double end_s = std::numeric_limits<double>::infinity();
};

struct Output {
  double fields_every_s = 0.02, structure_every_s = 0.01;  ///< 0: none
  int traces_every_steps = 1;
  std::vector<double> probes_z_cm{0.5, 3.5, 4.5, 5.5, 8.0, 14.5};
  bool pictures = true, report = true;
  double progress_every_s = 5;  ///< of the wall clock
};

struct Checkpoints {
  double every_wall_s = 300;  ///< 0: only at the end
  int keep = 2;
};

/// A measured trace to fit to: a column of the data.
struct FitSignal {
  std::string column, observable;
  std::optional<double> sd;
  bool baseline = false, shift = false;
};

struct Fit {
  std::string data;  ///< CSV, relative to the case; empty: none
  bool periodic = true;
  std::vector<lumped::FitParameter> parameters;
  std::vector<FitSignal> signals;
  std::vector<lumped::FitSummary> targets;
};

struct Case {
  std::string title;
  Time time;
  ib3d::Domain domain{{5.0, 5.0, 15.0}, {}};
  Grid grid;
  std::vector<Refine> refine;
  ib3d::FluidParameters fluid;
  ib3d::PressureOptions pressure;
  coupling::CouplingScheme coupling = coupling::CouplingScheme::implicit_;
  std::vector<ib3d::Opening> openings;  ///< none: a 0D case
  Structure structure;
  std::vector<MarkerGroup> markers;
  lumped::NetworkSpec network;  ///< its ports are those of the openings, in their order
  /// Numbers of the orifice_valve that stands for the 3D root in 0D; the defaults come from a 3D run of
  /// cases/aortic_root at h = 10/96 (docs/use/surrogate.md). The closed orifice hardly leaks.
  std::map<std::string, double> surrogate{{"area_open_cm2", 3.1},     {"area_closed_cm2", 1e-3},
                                          {"length_cm", 1.0},         {"opening_1_mmHg_s", 44.0},
                                          {"closing_1_mmHg_s", 2.95}, {"R_mmHg_s_ml", 0.0},
                                          {"L_mmHg_s2_ml", 0.0027}};
  Output output;
  Checkpoints checkpoints;
  Fit fit;

  casefile::CaseFile source;  ///< where every value stands, for refusals and copies of the case

  bool is_lumped() const { return openings.empty(); }
  /// Spacing of the finest level, cm; CaseError with spacings that would do where finest_cm does not divide the box.
  double finest_spacing() const
  {
    return ib3d::finest_spacing(domain, grid.finest_cm, grid.refinement.levels);
  }
  /// A file that the case names, relative to its folder.
  std::string path_of(const std::string& file) const;
};

}  // namespace valsalva::setup
