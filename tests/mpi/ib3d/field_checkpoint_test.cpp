// Fields in a checkpoint: every value comes back at its place, whatever the boxes it is read with.
#include "ib3d/grid/field_checkpoint.hpp"

#include <gtest/gtest.h>

#include "common/error.hpp"
#include "ib3d/output/mpi_session.hpp"

namespace valsalva::ib3d {
namespace {

Hierarchy grid_of(double length, int boxes)
{
  const Domain box{{length, length, 2 * length}, {}};
  return {box, 0.0625, MPI_COMM_WORLD, boxes};
}

double value_at(int kind, int i, int j, int k)
{
  return kind + 1e-3 * i + 1e-6 * j + 1e-9 * k;
}

struct Fields {
  explicit Fields(const Level& l) : level(l), p(l), u(l) {}
  template <class Do>
  void for_each(Do&& act)
  {
    for (int q = 0; q < level.local_count(); ++q) {
      for_each_index(level.local_box(q),
                     [&](int i, int j, int k) { act(p[q](i, j, k), value_at(3, i, j, k)); });
      for (int d = 0; d < 3; ++d)
        for_each_owned_face(level, q, d,
                            [&](int i, int j, int k) { act(u(q, d)(i, j, k), value_at(d, i, j, k)); });
    }
  }
  void save_or_restore(Checkpoint& c)
  {
    ib3d::save_or_restore(c, "p", level, p);
    ib3d::save_or_restore(c, "grid/u", level, u);
  }
  Level level;
  CellField<double> p;
  MacField u;
};

TEST(FieldCheckpoint, ValuesComeBackAtTheirPlaceWithOtherBoxes)
{
  const std::string path = shared_file("fields.h5");
  for (const auto& [written, read] : {std::pair{4, 4}, {4, 16}, {16, 4}}) {
    Fields before(grid_of(1.0, written).finest());
    before.for_each([](double& at, double value) { at = value; });
    Checkpoint out = Checkpoint::create(path, MPI_COMM_WORLD);
    before.save_or_restore(out);
    out.close();

    Fields after(grid_of(1.0, read).finest());
    Checkpoint in = Checkpoint::open(path, MPI_COMM_WORLD);
    after.save_or_restore(in);
    int wrong = 0;
    after.for_each([&](double& at, double value) { wrong += at == value ? 0 : 1; });
    EXPECT_EQ(wrong, 0) << written << " boxes written, " << read << " read";
  }
}

TEST(FieldCheckpoint, ALargerGridIsRefused)
{
  const std::string path = shared_file("small.h5");
  Fields small(grid_of(1.0, 4).finest());
  Checkpoint out = Checkpoint::create(path, MPI_COMM_WORLD);
  small.save_or_restore(out);
  out.close();
  Fields large(grid_of(2.0, 4).finest());
  Checkpoint in = Checkpoint::open(path, MPI_COMM_WORLD);
  EXPECT_THROW(large.save_or_restore(in), IoError);
}

}  // namespace
}  // namespace valsalva::ib3d
