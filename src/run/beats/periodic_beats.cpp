#include "run/beats/periodic_beats.hpp"

#include <fmt/format.h>

#include <cmath>

#include "common/max_or_nan.hpp"

namespace valsalva::run {

std::string PeriodicBeats::add(const BeatMetrics& beat)
{
  if (beat.period_s < (1 - 1e-6) * period_s_) return "        cut short, not compared with the beat before";
  const char* most = "";
  double largest = -1;
  const auto compare = [&](const char* name, double now, double& before) {
    const double scale = max_or_nan(std::abs(now), std::abs(before));
    const double change = scale == 0 ? 0.0 : std::abs(now - before) / scale;
    const double before_this = largest;
    largest = max_or_nan(largest, change);
    if (largest != before_this) most = name;
    before = now;
  };
  compare("stroke volume", beat.stroke_volume_ml, stroke_volume_);
  compare("mean aortic pressure", beat.p_ao_mean_mmHg, p_mean_);
  compare("systolic aortic pressure", beat.p_ao_systolic_mmHg, p_systolic_);
  compare("diastolic aortic pressure", beat.p_ao_diastolic_mmHg, p_diastolic_);
  const bool follows = beat_ > 0 && beat.beat == static_cast<int>(beat_) + 1;
  beat_ = beat.beat;
  change_ = follows ? largest : -1;
  if (!follows) return "        no beat before it to compare with";
  return fmt::format("        change from beat {}: {:.2g} % ({})", beat.beat - 1, 100 * largest, most);
}

std::string PeriodicBeats::outcome() const
{
  return fmt::format("periodic after {:.0f} beats", beat_);
}

void PeriodicBeats::save_or_restore(Checkpoint& c)
{
  c("beats/change", change_);
  c("beats/beat", beat_);
  c("beats/stroke_volume_ml", stroke_volume_);
  c("beats/p_ao_mean_mmHg", p_mean_);
  c("beats/p_ao_systolic_mmHg", p_systolic_);
  c("beats/p_ao_diastolic_mmHg", p_diastolic_);
}

}  // namespace valsalva::run
