#include "setup/network_from_case.hpp"

#include <filesystem>

#include "common/time_series.hpp"
#include "lumped/network/element_types.hpp"

namespace valsalva::setup {

namespace {

/// Fills in the table of a source that stands in a CSV. The value key is the type's first list.
void read_table(lumped::ElementSpec& element, const lumped::ElementType& type, const std::string& folder,
                const std::string& data_path)
{
  const auto column = element.words.find("column"), file = element.words.find("file");
  if (column == element.words.end()) return;
  const std::string path =
      file == element.words.end() ? data_path : (std::filesystem::path(folder) / file->second).string();
  if (path.empty()) return;
  const TimeSeries table = common::read_time_series(path);
  for (const lumped::ElementParameter& p : type.parameters)
    if (p.kind == lumped::ParameterKind::list) {
      element.lists[p.name] = table.column(column->second);
      break;
    }
  element.lists["time_s"] = table.column("t_s");
}

}  // namespace

double beat_length(const CaseFile& c)
{
  const CaseTable& time = c.section("time");
  return time.real("period_s") > 0 ? time.real("period_s") : time.real("end_s");
}

lumped::NetworkSpec network_from_case(const CaseFile& c, const std::string& data_path)
{
  lumped::NetworkSpec spec;
  spec.period_s = beat_length(c);
  for (const CaseTable& t : c.tables("element")) {
    lumped::ElementSpec element;
    element.name = t.text("name");
    element.type = t.text("type");
    const lumped::ElementType* type = lumped::find_element_type(element.type);
    for (const std::string& terminal : type->terminals) element.nodes[terminal] = t.text(terminal);
    for (const lumped::ElementParameter& p : type->parameters) {
      if (!t.has(p.name)) continue;
      switch (p.kind) {
        case lumped::ParameterKind::number:
          element.numbers[p.name] = t.real(p.name);
          break;
        case lumped::ParameterKind::list:
          element.lists[p.name] = t.reals(p.name);
          break;
        case lumped::ParameterKind::word:
          element.words[p.name] = t.text(p.name);
          break;
      }
    }
    read_table(element, *type, c.folder(), data_path);
    spec.elements.push_back(std::move(element));
  }
  for (const CaseTable& t : c.tables("opening")) spec.ports.push_back(t.text("port"));
  return spec;
}

}  // namespace valsalva::setup
