#include "common/stop_signal.hpp"

#include <csignal>

namespace valsalva::common {

namespace {

volatile std::sig_atomic_t g_stop = 0;

void note_signal(int number)
{
  g_stop = 1;
  if (number == SIGINT) std::signal(number, SIG_DFL);
}

}  // namespace

void catch_stop_signals()
{
  std::signal(SIGINT, note_signal);
  std::signal(SIGTERM, note_signal);
}

bool stop_requested()
{
  return g_stop != 0;
}

}  // namespace valsalva::common
