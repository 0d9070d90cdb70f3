#include "run/beats/beat_metrics.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "common/max_or_nan.hpp"
#include "common/units.hpp"

namespace valsalva::run {

namespace {

/// An orifice below this counts as shut: a slit of a tenth of a millimetre along the three lines of
/// coaptation.
constexpr double kShutOrifice_cm2 = 0.05;

/// Within this share of the beat after ejection lies the backflow that closes the valve.
constexpr double kLongestClosing = 0.25;

/// Of the peak flow: less is residual ringing of the closed valve at the start of a beat.
constexpr double kRemnant = 0.05;

/// Integral of f over the samples first..last by the trapezoidal rule.
template <class F>
double integral(const std::vector<BeatSample>& s, std::size_t first, std::size_t last, F&& f)
{
  double sum = 0;
  for (std::size_t n = first; n < last; ++n) sum += 0.5 * (f(s[n]) + f(s[n + 1])) * (s[n + 1].t_s - s[n].t_s);
  return sum;
}

double flow(const BeatSample& s)
{
  return s.flow_ml_s;
}

}  // namespace

BeatMetrics measure_beat(int beat, const std::vector<BeatSample>& s)
{
  BeatMetrics m;
  m.beat = beat;
  if (s.size() < 2) return m;
  const std::size_t end = s.size() - 1;
  m.start_s = s.front().t_s;
  m.period_s = s.back().t_s - m.start_s;
  m.mass_balance_ml = integral(s, 0, end, [](const BeatSample& x) { return x.inflow_ml_s; });
  m.p_ao_mean_mmHg = integral(s, 0, end, [](const BeatSample& x) { return x.p_aorta_mmHg; }) / m.period_s;

  const auto by_flow = [](const BeatSample& a, const BeatSample& b) { return a.flow_ml_s < b.flow_ml_s; };
  const auto peak = static_cast<std::size_t>(std::max_element(s.begin(), s.end(), by_flow) - s.begin());
  m.peak_flow_ml_s = s[peak].flow_ml_s;
  if (m.peak_flow_ml_s <= 0) return m;

  std::size_t rise = peak, fall = peak;
  while (rise > 0 && s[rise - 1].flow_ml_s > 0) --rise;
  std::size_t open = rise;
  if (rise == 0)  // the closed valve still rings from the previous beat
    for (open = peak; open > 0 && s[open - 1].flow_ml_s > kRemnant * m.peak_flow_ml_s;) --open;
  while (fall < end && s[fall].flow_ml_s > 0) ++fall;
  // A late ejection may hover about zero before the backflow that closes the valve.
  std::size_t least = fall;
  for (std::size_t n = fall; n <= end && s[n].t_s <= s[fall].t_s + kLongestClosing * m.period_s; ++n)
    if (s[n].flow_ml_s < s[least].flow_ml_s) least = n;
  const auto is_shut = [](const BeatSample& x) {
    return x.orifice_cm2 >= 0 && x.orifice_cm2 < kShutOrifice_cm2;
  };
  std::size_t shut = fall;
  while (shut < end && !is_shut(s[shut]) && (shut < least || s[shut].flow_ml_s < 0)) ++shut;
  m.opening_s = s[open].t_s;
  m.closing_s = s[shut].t_s;
  m.ejection_time_s = s[fall].t_s - s[open].t_s;
  m.least_flow_ml_s =
      std::min_element(s.begin() + static_cast<std::ptrdiff_t>(fall), s.end(), by_flow)->flow_ml_s;
  m.forward_volume_ml = integral(s, rise, fall, flow);
  m.closing_volume_ml = 0 - integral(s, fall, shut, flow);
  m.leak_volume_ml = 0 - integral(s, shut, end, flow);
  m.stroke_volume_ml = m.forward_volume_ml - m.closing_volume_ml - m.leak_volume_ml;
  if (s.back().t_s > s[shut].t_s) m.mean_leak_ml_s = m.leak_volume_ml / (s.back().t_s - s[shut].t_s);
  if (m.ejection_time_s > 0)
    m.mean_gradient_mmHg =
        integral(s, open, fall, [](const BeatSample& x) { return x.p_ventricle_mmHg - x.p_aorta_mmHg; }) /
        m.ejection_time_s;
  for (const BeatSample& x : s) m.max_orifice_area_cm2 = max_or_nan(m.max_orifice_area_cm2, x.orifice_cm2);
  // Diastolic: the lowest before ejection that the circulation itself made, so not the ramp from zero of a
  // first beat.
  m.p_ao_systolic_mmHg = m.p_ao_diastolic_mmHg = s[open].p_aorta_mmHg;
  for (std::size_t n = open; n <= end; ++n) {
    m.p_ao_systolic_mmHg = max_or_nan(m.p_ao_systolic_mmHg, s[n].p_aorta_mmHg);
    m.p_ao_diastolic_mmHg = min_or_nan(m.p_ao_diastolic_mmHg, s[n].p_aorta_mmHg);
  }
  return m;
}

std::vector<std::string> beat_columns()
{
  return {"beat",
          "start_s",
          "period_s",
          "stroke_volume_ml",
          "forward_volume_ml",
          "closing_volume_ml",
          "leak_volume_ml",
          "mean_leak_ml_s",
          "ejection_time_s",
          "opening_s",
          "closing_s",
          "peak_flow_ml_s",
          "least_flow_ml_s",
          "mean_gradient_mmHg",
          "max_orifice_area_cm2",
          "p_ao_systolic_mmHg",
          "p_ao_diastolic_mmHg",
          "p_ao_mean_mmHg",
          "mass_balance_ml",
          "network_inflow_ml",
          "network_volume_change_ml",
          "volume_residual_ml",
          "source_work_mJ",
          "network_loss_mJ",
          "network_energy_change_mJ",
          "root_work_mJ",
          "root_kinetic_inflow_mJ",
          "root_energy_change_mJ",
          "root_loss_mJ",
          "energy_residual_mJ"};
}

std::vector<double> beat_row(const BeatMetrics& m)
{
  return {static_cast<double>(m.beat),
          m.start_s,
          m.period_s,
          m.stroke_volume_ml,
          m.forward_volume_ml,
          m.closing_volume_ml,
          m.leak_volume_ml,
          m.mean_leak_ml_s,
          m.ejection_time_s,
          m.opening_s,
          m.closing_s,
          m.peak_flow_ml_s,
          m.least_flow_ml_s,
          m.mean_gradient_mmHg,
          m.max_orifice_area_cm2,
          m.p_ao_systolic_mmHg,
          m.p_ao_diastolic_mmHg,
          m.p_ao_mean_mmHg,
          m.mass_balance_ml,
          m.balance.network_inflow_ml,
          m.balance.network_volume_change_ml,
          m.balance.volume_residual_ml,
          m.balance.source_work_mJ,
          m.balance.network_loss_mJ,
          m.balance.network_energy_change_mJ,
          m.balance.root_work_mJ,
          m.balance.root_kinetic_inflow_mJ,
          m.balance.root_energy_change_mJ,
          m.balance.root_loss_mJ,
          m.balance.energy_residual_mJ};
}

std::string beat_text(const BeatMetrics& m)
{
  std::string text = fmt::format(
      "beat {}: stroke volume {:.1f} ml (forward {:.1f}, closing {:.1f}, leak {:.1f} at {:.2f} ml/s), peak "
      "flow {:.0f} "
      "ml/s, ejection {:.3f} s\n        mean gradient {:.1f} mmHg, aortic pressure {:.0f}/{:.0f} (mean "
      "{:.0f}) mmHg",
      m.beat, m.stroke_volume_ml, m.forward_volume_ml, m.closing_volume_ml, m.leak_volume_ml,
      m.mean_leak_ml_s, m.peak_flow_ml_s, m.ejection_time_s, m.mean_gradient_mmHg, m.p_ao_systolic_mmHg,
      m.p_ao_diastolic_mmHg, m.p_ao_mean_mmHg);
  if (m.max_orifice_area_cm2 > 0) text += fmt::format(", orifice {:.2f} cm^2", m.max_orifice_area_cm2);
  const BeatBalance& b = m.balance;
  text += fmt::format("\n        work of sources {:.0f} mJ = lost in the network {:.0f}", b.source_work_mJ,
                      b.network_loss_mJ);
  if (b.root_work_mJ != 0)
    text += fmt::format(" + lost in the root {:.0f} + leaving as kinetic energy {:.0f}", b.root_loss_mJ,
                        -b.root_kinetic_inflow_mJ);
  text += fmt::format(" + stored {:.0f}", b.network_energy_change_mJ + b.root_energy_change_mJ);
  return text;
}

}  // namespace valsalva::run
