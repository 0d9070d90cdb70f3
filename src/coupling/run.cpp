#include "coupling/run.hpp"

#include "coupling/coupled_run.hpp"
#include "coupling/lumped_run.hpp"

namespace valsalva::coupling {

int run_case(const CaseFile& case_file, const RunOptions& options)
{
  return is_lumped(case_file) || options.lumped ? run_lumped(case_file, options)
                                                : run_coupled(case_file, options);
}

}  // namespace valsalva::coupling
