// The front door: a TOML file becomes a Case, once. Everything that one look at the values can refuse is refused here:
// kinds and ranges by the key tables, what several keys say together by checks.hpp. CSVs of sources are read here.
#pragma once

#include <string>
#include <vector>

#include "common/time_series.hpp"
#include "setup/case.hpp"

namespace valsalva::setup {

/// Whether the CSVs of sources are read: not for the resolved case of a finished run, whose network is not run again.
enum class SourceTables { read, leave_out };

/// Reads, merges, overrides and checks. CaseError with all problems, each with its place; IoError for a file.
Case read_case(const std::string& path, const std::vector<std::string>& overrides = {},
               SourceTables source_tables = SourceTables::read);
/// The same from text; `name` stands for the file in messages and gives the folder of relative paths.
Case parse_case(const std::string& toml, const std::string& name,
                const std::vector<std::string>& overrides = {});

/// Fills in the table of a source from the column that its key `column` names, and from t_s. The values go to the first
/// list of the source's type. IoError for a missing column; a source without that key keeps its own values.
void set_source_table(lumped::ElementSpec& source, const TimeSeries& table);

}  // namespace valsalva::setup
