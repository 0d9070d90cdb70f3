#include "setup/fit_problem.hpp"

#include "common/time_series.hpp"
#include "setup/read_case.hpp"

namespace valsalva::setup {

lumped::FitProblem fit_problem(const Case& c, const std::string& data_path)
{
  if (!c.is_lumped())
    throw CaseError("opening",
                    "makes this a 3D case; only the parameters of a case without openings can be fitted.");
  std::string path = data_path;
  if (path.empty() && !c.fit.data.empty()) path = c.path_of(c.fit.data);
  if (path.empty() && !c.fit.signals.empty())
    throw CaseError("fit_signal." + c.fit.signals.front().column + ".name",
                    "needs measured data; give --data beat.csv, or fit.data in the case");

  lumped::FitProblem problem{c.network, c.fit.parameters, {}, c.fit.targets, c.fit.periodic};
  if (path.empty()) return problem;
  const TimeSeries data = common::read_time_series(path);
  for (lumped::ElementSpec& element : problem.network.elements)
    if (!element.words.contains("file")) set_source_table(element, data);
  for (const FitSignal& s : c.fit.signals)
    problem.signals.push_back({s.column, s.observable, data.column("t_s"), data.column(s.column),
                               s.sd.value_or(0.0), s.baseline, s.shift});
  return problem;
}

}  // namespace valsalva::setup
