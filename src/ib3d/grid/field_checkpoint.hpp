// Fields of one level in a checkpoint: every patch stores its own cells (or faces), with their box in global
// indices, so that another number of ranks with other patches finds its values again. Ghosts are not stored.
//   name          the values, box after box in the order of Level::patches, x fastest
//   name_boxes    lo and hi (hi exclusive) of every box
// Both calls are collective. IoError when the file does not cover the level.
#pragma once

#include <string>

#include "common/checkpoint.hpp"
#include "ib3d/grid/fields.hpp"

namespace valsalva::ib3d {

/// The boxes of the refined levels.
void save_or_restore(Checkpoint& c, const std::string& name, Refinement& boxes);
void save_or_restore(Checkpoint& c, const std::string& name, const Level& level, CellField<double>& field);
/// Names end in _x, _y, _z; faces that two patches share are stored once, by their owner.
void save_or_restore(Checkpoint& c, const std::string& name, const Level& level, MacField& field);

}  // namespace valsalva::ib3d
