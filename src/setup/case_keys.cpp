#include "setup/case_keys.hpp"

#include "setup/keys_parts.hpp"

namespace valsalva::setup {

namespace {

casefile::KeyTable all_keys()
{
  casefile::KeyTable table;
  table.sections.push_back(
      {"", "About the case", {casefile::text("title", "One line about the case").or_else("")}});
  for (auto& section : numerics_sections()) table.sections.push_back(section);
  for (auto& section : structure_sections()) table.sections.push_back(section);
  table.sections.push_back(surrogate_section());
  table.sections.push_back(output_section());
  table.sections.push_back(checkpoint_section());
  table.sections.push_back(fit_section());
  table.arrays = {opening_array(), refine_array(), markers_array(), element_array()};
  for (auto& array : fit_arrays()) table.arrays.push_back(array);
  return table;
}

}  // namespace

const casefile::KeyTable& case_keys()
{
  static const casefile::KeyTable table = all_keys();
  return table;
}

}  // namespace valsalva::setup
