#include "common/timers.hpp"

#include <fmt/format.h>

namespace valsalva::common {

std::size_t Timers::number_of(std::string_view phase)
{
  const auto found = numbers_.find(phase);
  if (found != numbers_.end()) return found->second;
  phases_.push_back({std::string(phase), 0.0, 0});
  numbers_.emplace(std::string(phase), phases_.size() - 1);
  return phases_.size() - 1;
}

void Timers::add(std::size_t phase, double seconds)
{
  phases_[phase].seconds += seconds;
  phases_[phase].calls += 1;
}

double Timers::seconds(std::string_view phase) const
{
  const auto found = numbers_.find(phase);
  return found == numbers_.end() ? 0.0 : phases_[found->second].seconds;
}

double Timers::wall() const
{
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

std::string Timers::table() const
{
  const double total = wall();
  std::string rows = fmt::format("{:<24}{:>10}{:>8}{:>10}{:>12}\n", "phase", "s", "%", "calls", "ms/call");
  for (const Phase& p : phases_)
    rows += fmt::format("{:<24}{:>10.2f}{:>8.1f}{:>10}{:>12.3f}\n", p.name, p.seconds,
                        100.0 * p.seconds / total, p.calls, 1e3 * p.seconds / static_cast<double>(p.calls));
  return rows + fmt::format("{:<24}{:>10.2f}{:>8.1f}\n", "wall", total, 100.0);
}

}  // namespace valsalva::common
