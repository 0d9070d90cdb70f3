// Openings, regions of refinement and groups of markers.
#include "setup/keys.hpp"

namespace valsalva::setup {

using namespace casefile;

namespace {

Array opening_array()
{
  using ib3d::Opening;
  using Key = BoundKey<Opening>;
  return bound_array<Case, Opening>(
      "opening", "A disc on a z plane of the box whose pressure a node of the lumped network prescribes",
      &Case::openings,
      {Key(text("name", "Unique name of the opening"), &Opening::name).needed(),
       Key(choice("side", {"z_lo", "z_hi"}, "Plane of the disc: lower or upper end of the box"),
           &Opening::side, std::vector{ib3d::Side::z_lo, ib3d::Side::z_hi})
           .needed(),
       Key(reals("center_cm", "cm", "Centre of the disc in x and y").of_count(2), &Opening::centre).needed(),
       Key(real("radius_cm", "cm", "Radius of the disc").above(0), &Opening::radius).needed(),
       Key(text("port", "Node of the network that is joined to the opening"), &Opening::port).needed()});
}

Array refine_array()
{
  using ib3d::RefinedRegion;
  using Key = BoundKey<Refine>;
  const auto region = [](auto member) { return at(&Refine::region, member); };
  return bound_array<Case, Refine>(
      "refine", "A region of the box that is refined whatever the structure and the flow", &Case::refine,
      {Key(text("name", "Unique name of the region"), &Refine::name).needed(),
       Key(reals("lo_cm", "cm", "Lower corner").of_count(3), region(&RefinedRegion::lo)).needed(),
       Key(reals("hi_cm", "cm", "Upper corner").of_count(3), region(&RefinedRegion::hi)).needed(),
       Key(integer("level", "Level that covers it; 0 is the coarsest").in(1, 8),
           region(&RefinedRegion::level))
           .needed()});
}

Array markers_array()
{
  using Key = BoundKey<MarkerGroup>;
  return bound_array<Case, MarkerGroup>(
      "markers", "Passive markers that the flow carries, written with the structure", &Case::markers,
      {Key(text("name", "Unique name of the group"), &MarkerGroup::name).needed(),
       Key(reals("z_cm", "cm", "Heights of the planes across z from which they are released").at_least(0),
           &MarkerGroup::z_cm)
           .needed(),
       {real("spacing_cm", "cm", "Distance of the markers within a plane").in(0.005, 10.0),
        &MarkerGroup::spacing_cm},
       {real("radius_cm", "cm",
             "Radius of the discs in these planes; 0: the lumen of the aortic root, else the narrowest "
             "opening's")
            .in(0.0, 100.0),
        &MarkerGroup::radius_cm},
       {reals("center_cm", "cm", "Centre of the discs in x and y; absent: root.center_cm").of_count(2),
        &MarkerGroup::centre_cm},
       {real("start_s", "s", "Time of the first release").at_least(0), &MarkerGroup::start_s},
       {real("every_s", "s", "Interval of further releases; 0: a single release").at_least(0),
        &MarkerGroup::every_s},
       {real("end_s", "s", "No release after this time; absent: until the end of the run").at_least(0),
        &MarkerGroup::end_s}});
}

}  // namespace

std::vector<Array> flow_arrays()
{
  return {opening_array(), refine_array(), markers_array()};
}

}  // namespace valsalva::setup
