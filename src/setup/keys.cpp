#include "setup/keys.hpp"

#include <iterator>

namespace valsalva::setup {

using namespace casefile;

namespace {

template <class List>
void append(List& list, List more)
{
  std::move(more.begin(), more.end(), std::back_inserter(list));
}

std::vector<Section> all_sections()
{
  std::vector<Section> all{bound_section<Case, Case>(
      "", "About the case", std::identity{}, {{text("title", "One line about the case"), &Case::title}})};
  append(all, numerics_sections());
  append(all, structure_sections());
  all.push_back(surrogate_section());
  append(all, output_sections());
  all.push_back(fit_section());
  return all;
}

std::vector<Array> all_arrays()
{
  std::vector<Array> all = flow_arrays();
  all.push_back(element_array());
  append(all, fit_arrays());
  return all;
}

KeyTable all_keys()
{
  KeyTable table;
  for (const Section& section : sections()) table.sections.push_back(section.keys);
  for (const Array& array : arrays()) table.arrays.push_back(array.keys);
  return table;
}

}  // namespace

const std::vector<Section>& sections()
{
  static const std::vector<Section> all = all_sections();
  return all;
}

const std::vector<Array>& arrays()
{
  static const std::vector<Array> all = all_arrays();
  return all;
}

const KeyTable& case_keys()
{
  static const KeyTable table = all_keys();
  return table;
}

}  // namespace valsalva::setup
