#include "lumped/elements/waveform.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace valsalva::lumped {

namespace {

/// "flow_ml_s" -> "_ml_s": the unit as a key ends in it.
std::string unit_ending(const std::string& value_key)
{
  return value_key.substr(value_key.find('_'));
}

template <class Scalar>
std::vector<double> plain_list(const ElementInput<Scalar>& input, const std::string& key)
{
  std::vector<double> values;
  for (const Scalar& v : input.list(key)) values.push_back(value_of(v));
  return values;
}

}  // namespace

template <class Scalar>
Waveform<Scalar>::Waveform(const ElementInput<Scalar>& input, const std::string& value_key)
    : times_(plain_list(input, "time_s")),
      values_(input.list(value_key)),
      cosine_(plain_list(input, "cosine" + unit_ending(value_key))),
      sine_(plain_list(input, "sine" + unit_ending(value_key))),
      heart_period_(input.case_period_s()),
      repeat_period_(input.word("beyond_table") == "repeat" ? heart_period_ : 0.0)
{
}

template <class Scalar>
Scalar Waveform<Scalar>::series(double t) const
{
  // The harmonics by rotation: one cosine and one sine for all of them.
  const double angle = 2.0 * std::numbers::pi * t / heart_period_;
  const double c1 = std::cos(angle), s1 = std::sin(angle);
  double c = 1.0, s = 0.0, sum = 0.0;
  for (std::size_t k = 0; k < std::max(cosine_.size(), sine_.size()); ++k) {
    const double next = c * c1 - s * s1;
    s = s * c1 + c * s1;
    c = next;
    if (k < cosine_.size()) sum += cosine_[k] * c;
    if (k < sine_.size()) sum += sine_[k] * s;
  }
  return values_.front() + sum;
}

template <class Scalar>
Scalar Waveform<Scalar>::value(Instant now) const
{
  if (values_.size() == 1) return cosine_.empty() && sine_.empty() ? values_.front() : series(now.t);
  double t = now.t, piece = now.piece;
  if (repeat_period_ > 0.0) {
    const double shift = repeat_period_ * std::floor((piece - times_.front()) / repeat_period_);
    t -= shift;
    piece -= shift;
  }
  const auto after = std::upper_bound(times_.begin(), times_.end(), piece);
  const auto i = static_cast<std::size_t>(after - times_.begin());
  if (i == 0) return values_.front();
  const bool is_inside = i < times_.size();
  if (!is_inside && repeat_period_ == 0.0) return values_.back();
  const double t0 = times_[i - 1], t1 = is_inside ? times_[i] : times_.front() + repeat_period_;
  const Scalar &v0 = values_[i - 1], &v1 = is_inside ? values_[i] : values_.front();
  return v0 + (v1 - v0) * ((t - t0) / (t1 - t0));
}

template <class Scalar>
Scalar Waveform<Scalar>::next_kink(double t) const
{
  const double later = t + kTimeResolution_s;
  if (values_.size() > 1) {
    const bool repeats = repeat_period_ > 0.0;
    const double first = repeats ? std::floor((later - times_.front()) / repeat_period_) : 0.0;
    for (double cycle = first; cycle <= first + (repeats ? 1.0 : 0.0); cycle += 1.0) {
      const double shift = cycle * repeat_period_;
      const auto kink = std::upper_bound(times_.begin(), times_.end(), later,
                                         [&](double limit, double time) { return limit < time + shift; });
      if (kink != times_.end()) return *kink + shift;
    }
  }
  return std::numeric_limits<double>::infinity();
}

template class Waveform<double>;
template class Waveform<Dual>;

std::vector<ElementParameter> waveform_parameters(const std::string& value_key, const std::string& unit,
                                                  const std::string& quantity, const std::string& meaning)
{
  const auto harmonics = [&](const std::string& name, const std::string& shape) {
    return ElementParameter{.name = name + unit_ending(value_key),
                            .unit = unit,
                            .kind = ParameterKind::list,
                            .quantity = quantity,
                            .required = false,
                            .meaning = "Fourier series about the constant: factors of the " + shape +
                                       " of 1, 2, ... beats per period"};
  };
  return {
      {.name = value_key,
       .unit = unit,
       .kind = ParameterKind::list,
       .quantity = quantity,
       .required = false,
       .meaning = meaning + ": a constant, or the values of a table"},
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
      harmonics("cosine", "cosines"),
      harmonics("sine", "sines"),
      {.name = "file",
       .kind = ParameterKind::word,
       .quantity = "a file",
       .required = false,
       .meaning = "CSV with the table, relative to the case; without it the data of `valsalva fit`"},
      {.name = "column",
       .kind = ParameterKind::word,
       .quantity = "a column",
       .required = false,
       .meaning = "Column of the CSV that holds the values; its times stand in t_s"},
  };
}

void check_waveform(const ElementSpec& element, const std::string& value_key, double period_s,
                    std::vector<CaseProblem>& problems)
{
  const auto report = [&](const std::string& key, const std::string& message) {
    problems.push_back({"", 0, 0, element_key(element, key), message});
  };
  const auto list = [&](const std::string& key) {
    const auto found = element.lists.find(key);
    return found == element.lists.end() ? std::vector<double>{} : found->second;
  };
  const std::vector<double> values = list(value_key), times = list("time_s");
  if (values.empty()) {
    report(value_key, element.words.count("column")
                          ? "is missing: the CSV column \"" + element.words.at("column") +
                                "\" has not been read. Give file, or run `valsalva fit` with --data."
                          : "is missing; give one number, a table with time_s, or file and column of a CSV.");
    return;
  }
  const bool has_harmonics =
      !list("cosine" + unit_ending(value_key)).empty() || !list("sine" + unit_ending(value_key)).empty();
  if (has_harmonics && values.size() > 1)
    report(value_key,
           "is a table, but a Fourier series is given too; keep one of them. The constant of a "
           "series is one number.");
  if (has_harmonics && period_s <= 0.0)
    report("cosine" + unit_ending(value_key),
           "needs the heart period, and the case names none; give time.period_s.");
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

}  // namespace valsalva::lumped
