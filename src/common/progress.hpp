// How long a run will still take, as text.
#pragma once

#include <string>

namespace valsalva::common {

/// "42 s", "3 min 10 s", "2 h 5 min", "3 d 4 h"; "?" for a negative or infinite duration.
std::string duration_text(double seconds);

/// The time left if `fraction` (0 to 1) of the work took `elapsed` seconds, in the words of `duration_text`;
/// "?" at fraction 0.
std::string eta_text(double fraction, double elapsed);

/// "[#########-----------]" of `width` signs between the brackets.
std::string progress_bar(double fraction, int width);

}  // namespace valsalva::common
