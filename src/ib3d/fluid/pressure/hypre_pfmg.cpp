#include "ib3d/fluid/pressure/hypre_pfmg.hpp"

#include <HYPRE_struct_ls.h>
#include <HYPRE_utilities.h>
#include <fmt/format.h>

#include "common/error.hpp"

namespace valsalva::ib3d {

struct HyprePfmg::Handles {
  HYPRE_StructGrid grid = nullptr;
  HYPRE_StructStencil stencil = nullptr;
  HYPRE_StructMatrix matrix = nullptr;
  HYPRE_StructVector rhs = nullptr, solution = nullptr;
  HYPRE_StructSolver solver = nullptr;
  std::vector<IndexBox> boxes;  ///< this rank's, in the order of the local patches
  std::vector<double> values;   ///< one box, contiguous

  ~Handles()
  {
    if (solver != nullptr) HYPRE_StructPFMGDestroy(solver);
    if (solution != nullptr) HYPRE_StructVectorDestroy(solution);
    if (rhs != nullptr) HYPRE_StructVectorDestroy(rhs);
    if (matrix != nullptr) HYPRE_StructMatrixDestroy(matrix);
    if (stencil != nullptr) HYPRE_StructStencilDestroy(stencil);
    if (grid != nullptr) HYPRE_StructGridDestroy(grid);
  }
};

namespace {

/// Throws for any error that hypre has noted so far.
void check(const char* what)
{
  HYPRE_ClearError(HYPRE_ERROR_CONV);  // "not converged" after a fixed number of cycles is not an error here
  const HYPRE_Int error = HYPRE_GetError();
  if (error == 0) return;
  char description[128] = "";
  HYPRE_DescribeError(error, description);
  HYPRE_ClearAllErrors();
  throw SolverError(fmt::format("hypre could not {}: {}(error {})", what, description, error));
}

/// hypre's boxes have inclusive upper corners.
Int3 last(const IndexBox& b)
{
  return {b.hi[0] - 1, b.hi[1] - 1, b.hi[2] - 1};
}

/// Rows of the matrix on one box: diagonal, then the neighbours x-, x+, y-, y+, z-, z+.
std::vector<double> matrix_rows(const PressureGrid& grid, int patch)
{
  const IndexBox& box = grid.level().local_box(patch);
  std::vector<double> rows;
  rows.reserve(static_cast<std::size_t>(7 * box.volume()));
  for_each_index(box, [&](int, int, int) { rows.insert(rows.end(), {6, -1, -1, -1, -1, -1, -1}); });
  for (const SidePlane<float>& theta : grid.shares(patch)) {
    theta.for_each(box.cells_inside(theta.side), [&](const Int3& at, int a, int b) {
      const auto row = static_cast<std::size_t>(
          7 * (at[0] - box.lo[0] + box.size(0) * (at[1] - box.lo[1] + box.size(1) * (at[2] - box.lo[2]))));
      rows[row] -= 1 - 2 * static_cast<double>(theta(a, b));
      rows[row + 1 + static_cast<std::size_t>(theta.side)] = 0;
    });
  }
  return rows;
}

}  // namespace

HyprePfmg::HyprePfmg(const PressureGrid& grid, int cycles) : hypre_(std::make_unique<Handles>())
{
  HYPRE_Init();
  Handles& h = *hypre_;
  const Level& level = grid.level();
  HYPRE_StructGridCreate(level.comm, 3, &h.grid);
  for (int p = 0; p < level.local_count(); ++p) {
    h.boxes.push_back(level.local_box(p));
    Int3 lo = h.boxes.back().lo, hi = last(h.boxes.back());
    HYPRE_StructGridSetExtents(h.grid, lo.data(), hi.data());
  }
  Int3 periods{};
  for (int d = 0; d < 3; ++d)
    periods[static_cast<std::size_t>(d)] = level.domain.periodic(d) ? level.box.size(d) : 0;
  HYPRE_StructGridSetPeriodic(h.grid, periods.data());
  HYPRE_StructGridAssemble(h.grid);

  Int3 offsets[7] = {{0, 0, 0}, {-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}};
  HYPRE_StructStencilCreate(3, 7, &h.stencil);
  for (int s = 0; s < 7; ++s) HYPRE_StructStencilSetElement(h.stencil, s, offsets[s].data());

  HYPRE_StructMatrixCreate(level.comm, h.grid, h.stencil, &h.matrix);
  HYPRE_StructMatrixInitialize(h.matrix);
  int entries[7] = {0, 1, 2, 3, 4, 5, 6};
  for (int p = 0; p < level.local_count(); ++p) {
    std::vector<double> rows = matrix_rows(grid, p);
    Int3 lo = h.boxes[static_cast<std::size_t>(p)].lo, hi = last(h.boxes[static_cast<std::size_t>(p)]);
    HYPRE_StructMatrixSetBoxValues(h.matrix, lo.data(), hi.data(), 7, entries, rows.data());
  }
  HYPRE_StructMatrixAssemble(h.matrix);
  for (HYPRE_StructVector* v : {&h.rhs, &h.solution}) {
    HYPRE_StructVectorCreate(level.comm, h.grid, v);
    HYPRE_StructVectorInitialize(*v);
    HYPRE_StructVectorAssemble(*v);
  }
  HYPRE_StructPFMGCreate(level.comm, &h.solver);
  HYPRE_StructPFMGSetTol(h.solver, 0.0);
  HYPRE_StructPFMGSetMaxIter(h.solver, cycles);
  HYPRE_StructPFMGSetRelaxType(h.solver, 2);
  HYPRE_StructPFMGSetRAPType(h.solver, 0);
  HYPRE_StructPFMGSetSkipRelax(h.solver, 1);
  HYPRE_StructPFMGSetZeroGuess(h.solver);
  HYPRE_StructPFMGSetup(h.solver, h.matrix, h.rhs, h.solution);
  check("set up PFMG");
}

HyprePfmg::~HyprePfmg() = default;

void HyprePfmg::solve(const CellField<float>& r, CellField<float>& z)
{
  Handles& h = *hypre_;
  for (std::size_t p = 0; p < h.boxes.size(); ++p) {
    const IndexBox& box = h.boxes[p];
    h.values.clear();
    for_each_row(box, [&](int j, int k) {
      const float* row = r[static_cast<int>(p)].at(box.lo[0], j, k);
      h.values.insert(h.values.end(), row, row + box.size(0));
    });
    Int3 lo = box.lo, hi = last(box);
    HYPRE_StructVectorSetBoxValues(h.rhs, lo.data(), hi.data(), h.values.data());
  }
  HYPRE_StructPFMGSolve(h.solver, h.matrix, h.rhs, h.solution);
  for (std::size_t p = 0; p < h.boxes.size(); ++p) {
    const IndexBox& box = h.boxes[p];
    h.values.resize(static_cast<std::size_t>(box.volume()));
    Int3 lo = box.lo, hi = last(box);
    HYPRE_StructVectorGetBoxValues(h.solution, lo.data(), hi.data(), h.values.data());
    const double* next = h.values.data();
    for_each_row(box, [&](int j, int k) {
      float* row = z[static_cast<int>(p)].at(box.lo[0], j, k);
      for (int i = 0; i < box.size(0); ++i) row[i] = static_cast<float>(*next++);
    });
  }
  check("solve the pressure problem with PFMG");
}

}  // namespace valsalva::ib3d
