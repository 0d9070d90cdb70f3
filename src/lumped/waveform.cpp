#include "lumped/waveform.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace valsalva::lumped {

Waveform::Waveform(std::vector<double> times, std::vector<double> values, double period)
    : times_(std::move(times)), values_(std::move(values)), period_(period)
{
}

double Waveform::value(Instant now) const
{
  if (values_.size() == 1) return values_.front();
  double t = now.t, piece = now.piece;
  if (period_ > 0.0) {
    const double shift = period_ * std::floor((piece - times_.front()) / period_);
    t -= shift;
    piece -= shift;
  }
  const auto after = std::upper_bound(times_.begin(), times_.end(), piece);
  const auto i = static_cast<std::size_t>(after - times_.begin());
  if (i == 0) return values_.front();
  double t1, v1;
  if (i < times_.size()) {
    t1 = times_[i];
    v1 = values_[i];
  } else if (period_ > 0.0) {
    t1 = times_.front() + period_;
    v1 = values_.front();
  } else {
    return values_.back();
  }
  const double t0 = times_[i - 1], v0 = values_[i - 1];
  return v0 + (v1 - v0) * ((t - t0) / (t1 - t0));
}

double Waveform::next_kink(double t) const
{
  const double later = t + kTimeResolution_s;
  if (values_.size() > 1) {
    const double first = period_ > 0.0 ? std::floor((later - times_.front()) / period_) : 0.0;
    for (double cycle = first; cycle <= first + (period_ > 0.0 ? 1.0 : 0.0); cycle += 1.0) {
      const double shift = cycle * period_;
      const auto kink = std::upper_bound(times_.begin(), times_.end(), later,
                                         [&](double limit, double time) { return limit < time + shift; });
      if (kink != times_.end()) return *kink + shift;
    }
  }
  return std::numeric_limits<double>::infinity();
}

std::vector<ElementParameter> waveform_parameters(const std::string& value_key, const std::string& unit,
                                                  const std::string& quantity, const std::string& meaning)
{
  return {
      {.name = value_key,
       .unit = unit,
       .kind = ParameterKind::list,
       .quantity = quantity,
       .meaning = meaning},
      {.name = "time_s",
       .unit = "s",
       .kind = ParameterKind::list,
       .quantity = "a time",
       .required = false,
       .meaning = "Times of the table's values, increasing; between them the signal is linear"},
      {.name = "beyond_table",
       .kind = ParameterKind::word,
       .quantity = "a continuation",
       .default_word = "hold",
       .choices = {"hold", "repeat"},
       .meaning = "Outside the table: hold its end values, or repeat it every heart period"},
  };
}

void check_waveform(const ElementSpec& element, const std::string& value_key, double period_s,
                    std::vector<CaseProblem>& problems)
{
  const auto report = [&](const std::string& key, const std::string& message) {
    problems.push_back({"", 0, 0, element_key(element, key), message});
  };
  const std::vector<double>& values = element.lists.at(value_key);
  const auto found = element.lists.find("time_s");
  const std::vector<double> times = found == element.lists.end() ? std::vector<double>{} : found->second;
  if (times.empty() && values.size() == 1) return;
  if (times.size() != values.size()) {
    report("time_s", fmt::format("has {} entries, {} has {}; a table needs as many times as values.",
                                 times.size(), value_key, values.size()));
    return;
  }
  for (std::size_t i = 1; i < times.size(); ++i)
    if (times[i] <= times[i - 1]) {
      report("time_s",
             fmt::format("goes from {} s to {} s at entry {}; times must increase. For a jump, give it a "
                         "short rise time.",
                         times[i - 1], times[i], i + 1));
      return;
    }
  if (element.words.at("beyond_table") != "repeat") return;
  const double length = times.back() - times.front();
  if (period_s <= 0.0)
    report("beyond_table", "is \"repeat\", but the case names no heart period; give time.period_s.");
  else if (length > period_s + kTimeResolution_s)
    report("time_s",
           fmt::format("covers {} s, more than the heart period of {} s after which it repeats; shorten "
                       "the table or lengthen time.period_s.",
                       length, period_s));
  else if (length > period_s - kTimeResolution_s && values.front() != values.back())
    report(value_key,
           fmt::format("ends at {} and begins at {}; a table that covers the whole period must end as it "
                       "begins.",
                       values.back(), values.front()));
}

Waveform read_waveform(const ElementSpec& element, const std::string& value_key, double period_s)
{
  const auto times = element.lists.find("time_s");
  const bool repeat = element.words.at("beyond_table") == "repeat";
  return Waveform(times == element.lists.end() ? std::vector<double>{} : times->second,
                  element.lists.at(value_key), repeat ? period_s : 0.0);
}

}  // namespace valsalva::lumped
