#include "run/run.hpp"

#include "run/loop.hpp"
#include "run/lumped_loop.hpp"

namespace valsalva::run {

int run_case(const CaseFile& case_file, const RunOptions& options)
{
  return setup::is_lumped(case_file) || options.lumped ? run_lumped(case_file, options)
                                                       : run_coupled(case_file, options);
}

}  // namespace valsalva::run
