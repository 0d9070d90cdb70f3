// Units that people use <-> CGS, which the 3D solver uses inside. The only place with 1333.22.
#pragma once

namespace valsalva::common {

/// 1 mmHg in dyn/cm^2.
inline constexpr double kMmHg = 1333.22;

constexpr double dyn_cm2_from_mmHg(double p_mmHg)
{
  return kMmHg * p_mmHg;
}
constexpr double mmHg_from_dyn_cm2(double p_dyn_cm2)
{
  return p_dyn_cm2 / kMmHg;
}
constexpr double mJ_from_mmHg_ml(double energy_mmHg_ml)
{
  return 1e-4 * kMmHg * energy_mmHg_ml;
}
constexpr double mJ_from_erg(double energy_erg)
{
  return 1e-4 * energy_erg;
}
constexpr double l_min_from_ml_s(double q_ml_s)
{
  return 0.06 * q_ml_s;
}

}  // namespace valsalva::common
