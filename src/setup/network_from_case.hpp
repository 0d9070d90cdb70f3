// From the case file to the lumped network. A source with the key `column` takes its table from a CSV: from its
// `file` (relative to the case), or without one from `data_path`, the data of `valsalva fit`.
#pragma once

#include <string>

#include "casefile/case_file.hpp"
#include "lumped/network/network_spec.hpp"

namespace valsalva::setup {

/// Length of a heart beat, s: time.period_s, or the whole run where that is 0.
double beat_length(const CaseFile& c);

/// The ports are those of the openings, in their order. Throws CaseError; IoError for a CSV.
lumped::NetworkSpec network_from_case(const CaseFile& c, const std::string& data_path = "");

}  // namespace valsalva::setup
