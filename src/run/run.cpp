#include "run/run.hpp"

#include "run/loop.hpp"
#include "run/lumped_loop.hpp"

namespace valsalva::run {

int run_case(const Case& c, const RunOptions& options, const Communicator& comm)
{
  return c.is_lumped() || options.lumped ? run_lumped(c, options, comm) : run_coupled(c, options, comm);
}

}  // namespace valsalva::run
