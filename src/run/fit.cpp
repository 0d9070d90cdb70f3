#include "run/fit.hpp"

#include <filesystem>

#include "common/comm.hpp"
#include "common/error.hpp"
#include "common/log.hpp"
#include "common/output_folder.hpp"
#include "common/time_series.hpp"
#include "run/fit_output.hpp"
#include "setup/network_from_case.hpp"

namespace valsalva::run {

namespace {

std::string data_path(const CaseFile& c, const FitOptions& options)
{
  if (!options.data_path.empty()) return options.data_path;
  const std::string& in_case = c.section("fit").text("data");
  return in_case.empty() ? "" : (std::filesystem::path(c.folder()) / in_case).string();
}

lumped::SummaryKind kind_of(const std::string& word)
{
  if (word == "systolic") return lumped::SummaryKind::systolic;
  if (word == "diastolic") return lumped::SummaryKind::diastolic;
  return word == "mean" ? lumped::SummaryKind::mean : lumped::SummaryKind::volume;
}

lumped::FitProblem problem_from_case(const CaseFile& c, const std::string& path)
{
  lumped::FitProblem problem;
  problem.network = setup::network_from_case(c, path);
  problem.periodic = c.section("fit").flag("periodic");
  for (const CaseTable& t : c.tables("fit_parameter")) {
    lumped::FitParameter p{t.text("parameter")};
    if (t.has("lowest")) p.lowest = t.real("lowest");
    if (t.has("highest")) p.highest = t.real("highest");
    problem.parameters.push_back(p);
  }
  for (const CaseTable& t : c.tables("fit_signal")) {
    if (path.empty())
      throw CaseError(
          {t.problem("name", "needs measured data; give --data beat.csv, or fit.data in the case")});
    const TimeSeries data = common::read_time_series(path);
    lumped::FitSignal signal{t.text("name"), t.text("observable"), data.column("t_s"),
                             data.column(t.text("name"))};
    if (t.has("sd")) signal.sd = t.real("sd");
    signal.has_baseline = t.flag("baseline");
    signal.has_shift = t.flag("shift");
    problem.signals.push_back(std::move(signal));
  }
  for (const CaseTable& t : c.tables("fit_target"))
    problem.summaries.push_back(
        {t.text("name"), kind_of(t.text("kind")), t.text("observable"), t.real("value"), t.real("sd")});
  return problem;
}

}  // namespace

int fit_case(const CaseFile& c, const FitOptions& options)
{
  if (!c.tables("opening").empty())
    throw CaseError("opening",
                    "makes this a 3D case; only the parameters of a case without openings can be fitted.");
  const Communicator comm;
  const lumped::FitProblem problem = problem_from_case(c, data_path(c, options));
  // On every rank, with the same result: a problem that is refused then leaves no folder behind.
  const lumped::Fit fit = lumped::fit(problem);
  common::create_output_folder(options.out_dir, options.force, c.resolved_toml(), comm);
  if (!comm.is_rank_0()) return 0;
  const std::string text = write_fit(options.out_dir, fit);
  Log log(true, options.out_dir + "/log.txt");
  log.line(c.section("").text("title") + "\n\n" + text);
  log.line("results in " + options.out_dir);
  log.check();
  return 0;
}

}  // namespace valsalva::run
