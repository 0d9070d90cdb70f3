// What one beat did, from its traces: the numbers that clinicians and papers quote. ml, s, mmHg, cm^2.
// The beat's ejection begins where the flow last rises through zero before its peak (through 5 % of the peak if it
// was positive from the start) and ends where it next falls through zero. The closing volume is the net backflow
// from there until the valve has closed: the flow returns to zero after its least value within a quarter of the
// beat, or the orifice is shut. Backflow after that is leak.
#pragma once

#include <string>
#include <vector>

#include "run/beats/beat_balance.hpp"

namespace valsalva::run {

/// One row of the traces.
struct BeatSample {
  double t_s = 0;
  double flow_ml_s = 0;  ///< through the aortic valve, forward positive
  double p_ventricle_mmHg = 0;
  double p_aorta_mmHg = 0;
  double orifice_cm2 = -1;  ///< negative: not known (0D)
  double inflow_ml_s = 0;   ///< into the 3D domain, all openings: its integral is the balance of volume
};

/// One row of beats.csv (docs/outputs.md).
struct BeatMetrics {
  int beat = 0;
  double start_s = 0, period_s = 0;
  double stroke_volume_ml = 0;  ///< net: forward - closing - leak
  double forward_volume_ml = 0, closing_volume_ml = 0, leak_volume_ml = 0;
  double mean_leak_ml_s = 0;  ///< leak volume over the time from closure to the end of the beat
  double ejection_time_s = 0, opening_s = 0, closing_s = 0;  ///< opening and closing are instants
  double peak_flow_ml_s = 0, least_flow_ml_s = 0, mean_gradient_mmHg = 0, max_orifice_area_cm2 = 0;
  double p_ao_systolic_mmHg = 0, p_ao_diastolic_mmHg = 0, p_ao_mean_mmHg = 0;
  double mass_balance_ml = 0;
  BeatBalance balance;  ///< filled in by the run
};

/// The metrics of beat number `beat` (from 1) from its samples in order of time; zeros where nothing was
/// ejected.
BeatMetrics measure_beat(int beat, const std::vector<BeatSample>& samples);

/// Column names and one row for beats.csv, in the same order.
std::vector<std::string> beat_columns();
std::vector<double> beat_row(const BeatMetrics& m);

/// The numbers of a beat in three lines of text.
std::string beat_text(const BeatMetrics& m);

}  // namespace valsalva::run
