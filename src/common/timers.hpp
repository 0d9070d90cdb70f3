// Where the time goes: named phases, each with its wall time and number of calls.
//   { const auto scope = timers.time("projection"); ... }
// Phases may nest; each then counts the time of those inside it as well.
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace valsalva::common {

class Timers {
 public:
  using Clock = std::chrono::steady_clock;

  struct Phase {
    std::string name;
    double seconds = 0.0;
    long calls = 0;
  };

  /// Adds the time of its life to a phase.
  class Scope {
   public:
    Scope(Timers& timers, std::size_t phase) : timers_(timers), phase_(phase), start_(Clock::now()) {}
    ~Scope() { timers_.add(phase_, std::chrono::duration<double>(Clock::now() - start_).count()); }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    Timers& timers_;
    std::size_t phase_;
    Clock::time_point start_;
  };

  [[nodiscard]] Scope time(std::string_view phase) { return {*this, number_of(phase)}; }
  double seconds(std::string_view phase) const;  ///< 0 for a phase that never ran
  double wall() const;                           ///< s since construction
  const std::vector<Phase>& phases() const { return phases_; }
  /// Table: phase, seconds, share of `wall()`, calls, ms per call; phases in the order of their first call.
  std::string table() const;

 private:
  std::size_t number_of(std::string_view phase);
  void add(std::size_t phase, double seconds);
  std::vector<Phase> phases_;
  std::map<std::string, std::size_t, std::less<>> numbers_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace valsalva::common

namespace valsalva {
using common::Timers;
}  // namespace valsalva
