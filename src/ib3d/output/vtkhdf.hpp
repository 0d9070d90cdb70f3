// Output that ParaView opens by itself: VTKHDF files (version 1.0), one per output time, shared by all ranks.
//   OverlappingAMR    the fields on all levels; a level's blocks stand one after the other, x fastest
//   UnstructuredGrid  the structure: elements as lines or triangles, points without one as vertices; a piece per rank
//                     markers as vertices, a piece per rank
// Arrays are float32, their names carry the units: velocity_cm_s, pressure_mmHg, strain, force_dyn, age_s;
// `group` is the number of a point's group. The file's root has the attributes time_s and group_names
// (one name a line). Name the files *.hdf: ParaView 5.11 finds no reader for .vtkhdf; their times belong
// in a FileSeries. All functions are collective and throw IoError on all ranks.
// Source: docs.vtk.org, VTKHDF file format.
#pragma once

#include <mpi.h>

#include <array>
#include <string>
#include <vector>

#include "ib3d/grid/index_box.hpp"
#include "ib3d/structure/elastic_model.hpp"

namespace valsalva::ib3d {

/// The values in the cells of box number `order` of its level.
struct AmrBlock {
  int order = 0;
  std::vector<float> velocity;  ///< 3 per cell, cm/s
  std::vector<float> pressure;  ///< 1 per cell, mmHg
};

struct AmrLevel {
  double spacing = 0.0;         ///< cm
  std::vector<IndexBox> boxes;  ///< all boxes of the level, the same list on every rank
  std::vector<AmrBlock> local;  ///< this rank's; each box is on one rank
};

/// The structure as this rank sees it; numbers in `elements` count this rank's points.
struct StructurePicture {
  std::vector<Vec3> points;   ///< cm
  std::vector<int> group;     ///< per point
  Elements elements;          ///< of two or three points
  std::vector<float> strain;  ///< per element
  std::vector<Vec3> force;    ///< per point, dyn; empty on every rank: not written
};

/// The passive markers as this rank sees them.
struct MarkerPicture {
  std::vector<Vec3> points;  ///< cm
  std::vector<int> id, group;
  std::vector<float> age;  ///< s since release
};

/// `origin` is the corner of cell (0, 0, 0) of every level, cm; levels[0] is the coarsest.
void write_overlapping_amr(const std::string& path, double time_s, const Vec3& origin,
                           const std::vector<AmrLevel>& levels, MPI_Comm comm);

/// `group_names[g]` is the name of group g.
void write_structure(const std::string& path, double time_s, const StructurePicture& structure,
                     const std::vector<std::string>& group_names, MPI_Comm comm);
void write_markers(const std::string& path, double time_s, const MarkerPicture& markers,
                   const std::vector<std::string>& group_names, MPI_Comm comm);

}  // namespace valsalva::ib3d
