#include "common/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace valsalva::common {

std::string duration_text(double seconds)
{
  if (!(seconds >= 0.0) || seconds > 1e9) return "?";
  const long s = std::lround(seconds);
  if (s < 60) return fmt::format("{} s", s);
  if (s < 3600) return fmt::format("{} min {} s", s / 60, s % 60);
  if (s < 86400) return fmt::format("{} h {} min", s / 3600, s % 3600 / 60);
  return fmt::format("{} d {} h", s / 86400, s % 86400 / 3600);
}

std::string eta_text(double fraction, double elapsed)
{
  if (!(fraction > 0.0)) return "?";
  return duration_text(elapsed * (1.0 - std::min(fraction, 1.0)) / fraction);
}

std::string progress_bar(double fraction, int width)
{
  const auto done = static_cast<std::size_t>(std::lround(std::clamp(fraction, 0.0, 1.0) * width));
  return fmt::format("[{:#<{}}{:-<{}}]", "", done, "", static_cast<std::size_t>(width) - done);
}

}  // namespace valsalva::common
