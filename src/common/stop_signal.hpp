// A polite end: SIGINT (Ctrl-C) and SIGTERM set a flag that the time loop reads between steps. A second SIGINT ends
// the program at once; a second SIGTERM does not, since launchers repeat what a batch system has sent to all already.
#pragma once

namespace valsalva::common {

/// From now on the two signals are caught.
void catch_stop_signals();

/// Has one of them arrived on this rank? Ranks must agree (`Communicator::any`) before they act.
bool stop_requested();

}  // namespace valsalva::common
