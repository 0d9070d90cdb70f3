#include "run/fit.hpp"

#include "common/log.hpp"
#include "common/output_folder.hpp"
#include "run/fit_output.hpp"
#include "setup/fit_problem.hpp"

namespace valsalva::run {

int fit_case(const setup::Case& c, const FitOptions& options, const Communicator& comm)
{
  // On every rank, with the same result: a problem that is refused then leaves no folder behind.
  const lumped::Fit fit = lumped::fit(setup::fit_problem(c, options.data_path));
  common::create_output_folder(options.out_dir, options.force, c.source.resolved_toml(), comm);
  if (!comm.is_rank_0()) return 0;
  const std::string text = write_fit(options.out_dir, fit);
  Log log(true, options.out_dir + "/log.txt");
  log.line(c.title + "\n\n" + text);
  log.line("results in " + options.out_dir);
  log.check();
  return 0;
}

}  // namespace valsalva::run
