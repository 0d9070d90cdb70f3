#include "setup/same_run.hpp"

#include <fmt/format.h>

#include "setup/keys.hpp"

namespace valsalva::setup {

namespace {

bool may_change(const std::string& key)
{
  if (key == "output.probes_z_cm") return false;  // the columns of probes.csv
  return key == "title" || key == "time.end_s" || key == "time.stop_when_periodic_within" ||
         key.starts_with("output.") || key.starts_with("checkpoint.");
}

double beat_of(const casefile::CaseFile& file)
{
  Time time;
  time.end_s = file.section("time").real("end_s");
  time.period_s = file.section("time").real("period_s");
  return time.beat_s();
}

}  // namespace

void check_same_run(const Case& now, const std::string& then, const std::string& checkpoint)
{
  const casefile::CaseFile earlier = casefile::CaseFile::parse(then, checkpoint, case_keys());
  std::vector<CaseProblem> problems;
  for (CaseProblem& p : now.source.differences_from(earlier)) {
    if (may_change(p.key) || p.key == "time.period_s") continue;
    p.message += " when " + checkpoint + " was written; restore it, or start again with --force";
    problems.push_back(std::move(p));
  }
  if (const double beat = now.time.beat_s(), beat_then = beat_of(earlier); beat != beat_then)
    problems.push_back(now.source.section("time").problem(
        "period_s", fmt::format("the beat is {:.9g} s long now, it was {:.9g} s when {} was written; set "
                                "time.period_s = {:.9g}, or start again with --force",
                                beat, beat_then, checkpoint, beat_then)));
  if (!problems.empty()) throw CaseError(problems);
}

}  // namespace valsalva::setup
