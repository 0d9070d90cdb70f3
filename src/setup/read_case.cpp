#include "setup/read_case.hpp"

#include <filesystem>

#include "common/time_series.hpp"
#include "lumped/network/element_types.hpp"
#include "setup/checks.hpp"
#include "setup/keys.hpp"

namespace valsalva::setup {

namespace {

/// Tables of sources that stand in CSVs of their own. Those of the data of a fit come with the data (fit_problem.hpp).
void read_source_tables(Case& c)
{
  std::map<std::string, TimeSeries> tables;
  for (lumped::ElementSpec& element : c.network.elements) {
    const auto file = element.words.find("file");
    if (file == element.words.end() || !element.words.contains("column")) continue;
    const std::string path = c.path_of(file->second);
    if (!tables.contains(path)) tables[path] = common::read_time_series(path);
    set_source_table(element, tables[path]);
  }
}

Case case_of(casefile::CaseFile file, SourceTables source_tables)
{
  Case c;
  for (const Section& section : sections()) section.read(c, file.section(section.keys.name));
  for (const Array& array : arrays()) array.read(c, file.tables(array.keys.name));
  c.structure.root.length = c.domain.size[2];
  c.network.period_s = c.time.beat_s();
  for (const ib3d::Opening& o : c.openings) c.network.ports.push_back(o.port);
  c.source = std::move(file);
  if (const std::vector<CaseProblem> problems = problems_of(c); !problems.empty())
    throw c.source.locate(CaseError(problems));
  if (source_tables == SourceTables::read) read_source_tables(c);
  return c;
}

}  // namespace

std::string Case::path_of(const std::string& file) const
{
  return (std::filesystem::path(source.folder()) / file).string();
}

void set_source_table(lumped::ElementSpec& source, const TimeSeries& table)
{
  const auto column = source.words.find("column");
  if (column == source.words.end()) return;
  for (const lumped::ElementParameter& p : lumped::find_element_type(source.type)->parameters)
    if (p.kind == lumped::ParameterKind::list) {
      source.lists[p.name] = table.column(column->second);
      break;
    }
  source.lists["time_s"] = table.column("t_s");
}

Case read_case(const std::string& path, const std::vector<std::string>& overrides, SourceTables source_tables)
{
  return case_of(casefile::CaseFile::read(path, case_keys(), overrides), source_tables);
}

Case parse_case(const std::string& toml, const std::string& name, const std::vector<std::string>& overrides)
{
  return case_of(casefile::CaseFile::parse(toml, name, case_keys(), overrides), SourceTables::read);
}

}  // namespace valsalva::setup
