// A small key table for the tests of the case reader, and the sentences of what it refuses.
#pragma once

#include <string>
#include <vector>

#include "casefile/case_file.hpp"
#include "complaint.hpp"

namespace valsalva::casefile {

inline KeyTable small_keys()
{
  return {{{"", "About the case", {text("title", "One line").or_else("")}},
           {"time",
            "Time",
            {real("end_s", "s", "End of the run").above(0),
             real("cfl", "", "CFL number").in(0.05, 0.5).or_else(0.4),
             integer("max_steps", "Steps").in(1, 1000).or_else(10), flag("pictures", "Draw").or_else(true)}},
           {"grid",
            "Grid",
            {real("finest_cm", "cm", "Spacing").in(0.001, 1).or_else(0.1),
             reals("size_cm", "cm", "Box").above(0).of_count(3).or_else({5, 5, 15}),
             reals("probes_cm", "cm", "Heights").at_least(0).or_else({0.5}),
             choice("sides", {"wall", "open", "periodic"}, "Sides").or_else("wall")}}},
          {{"element",
            "Elements",
            {text("name", "Name")},
            {{"windkessel3",
              "Arteries",
              {text("node", "Node"), real("Rp_mmHg_s_ml", "mmHg s/ml", "Resistance").above(0).example(0.79),
               real("pressure_mmHg", "mmHg", "Start").or_else(0.0)}},
             {"source",
              "Source",
              {reals("pressure_mmHg", "mmHg", "Pressure"), real("delay_s", "s", "Delay").optional()}}}}}};
}

inline CaseFile parse_small(const std::string& toml, const std::vector<std::string>& overrides = {})
{
  return CaseFile::parse(toml, "small.toml", small_keys(), overrides);
}

/// The whole text of the CaseError that `toml` causes, or an empty text if it is accepted.
inline std::string refusal(const std::string& toml, const std::vector<std::string>& overrides = {})
{
  return complaint([&] { parse_small(toml, overrides); });
}

}  // namespace valsalva::casefile
