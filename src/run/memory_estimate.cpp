#include "run/memory_estimate.hpp"

namespace valsalva::run {

namespace {

constexpr double kDouble = 8, kFloat = 4, kInt = 4, kVector = 24;  // bytes
/// Of one rank before it holds anything of a case, MB: measured with Open MPI 4.1 on Debian 12.
constexpr double kProgram_mb = 28;

/// Values of a field with this many ghosts on the local patches.
double stored_values(const ib3d::Level& level, int ghosts)
{
  double n = 0;
  for (int p = 0; p < level.local_count(); ++p)
    n += static_cast<double>(ib3d::stored_box(level.local_box(p), ghosts).volume());
  return n;
}

double fields_of(setup::CaseModel& model)
{
  const ib3d::NavierStokes& fluid = model.solver().fluid();
  const bool implicit = fluid.fluid().viscosity_scheme == ib3d::ViscosityScheme::crank_nicolson;
  double bytes = 0;
  for (int l = 0; l < model.grid().level_count(); ++l) {
    const ib3d::Level& level = model.grid().level(l);
    const bool finest = l + 1 == model.grid().level_count();
    // u^n, u^{n+1}, rate; three more for the implicit solve; force and elastic bound on the finest, else the shadow
    // that the next finer level sees
    const int velocities = 3 + (implicit ? 3 : 0) + (finest ? 2 : 1);
    bytes += velocities * 3 * kDouble * stored_values(level, ib3d::kMacGhosts);
    // p of three steps and a mode per opening; conjugate gradients (4), multigrid (2), coefficients (3)
    const double modes = static_cast<double>(fluid.openings().size());
    bytes += ((3 + modes) * kDouble + (4 + 2 + 3) * kFloat) * stored_values(level, 1);
  }
  return bytes;
}

double structure_of(setup::CaseModel& model)
{
  const ib3d::FibreNetwork& n = model.structure().network;
  const double springs = n.springs.count() * (2 * kInt + 2 * kDouble + 1.0);
  const double beams = n.beams.count() * (3 * kInt + 3 * kDouble);
  const double tethers = n.tethers.count() * (kInt + kDouble + kVector);
  const double network = n.node_count() * kVector + springs + beams + tethers;
  // three times the network (case, owner, own part); three lists of all nodes; the part's vectors of the steps
  const double own = static_cast<double>(model.solver().nodes().owned()) * 8 * kVector;
  return 3 * network + n.node_count() * (3 * kVector + kInt) + own;
}

}  // namespace

MemoryEstimate estimate_memory(setup::CaseModel& model, const Communicator& comm)
{
  MemoryEstimate m;
  m.fields_mb = comm.sum(fields_of(model)) / 1e6;
  m.structure_mb = comm.sum(structure_of(model)) / 1e6;
  m.program_mb = kProgram_mb * comm.size();
  m.regrid_mb = model.grid().level_count() > 1 ? m.fields_mb : 0;
  return m;
}

}  // namespace valsalva::run
