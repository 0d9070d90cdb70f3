#include "run/progress.hpp"

#include <fmt/format.h>

#include "common/progress.hpp"

namespace valsalva::run {

ProgressLines::ProgressLines(Log& log, const coupling::CoupledModel& now, double end_s, double every_s,
                             double wall_s)
    : log_(log),
      begin_s_(now.t()),
      end_s_(end_s),
      every_s_(every_s),
      begun_(wall_s),
      told_(wall_s),
      shown_(wall_s),
      told_step_(now.step())
{
}

void ProgressLines::tell(const coupling::StepReport& s, const BeatSample& now, int beat, double wall_s)
{
  const std::string eta = common::eta_text((s.t_s - begin_s_) / (end_s_ - begin_s_), wall_s - begun_);
  if (wall_s - told_ > every_s_) {
    log_.line(
        fmt::format("step {:>6}  t {:.4f} s (beat {})  dt {:.1e} ({})  CFL {:.2f}  p_lv {:.1f} p_ao {:.1f} "
                    "mmHg  Q {:.0f} ml/s  "
                    "{:.0f} ms/step  ETA {}",
                    s.step, s.t_s, beat, s.dt_s, ib3d::limit_name(s.limited_by), s.cfl, now.p_ventricle_mmHg,
                    now.p_aorta_mmHg, now.flow_ml_s,
                    1e3 * (wall_s - told_) / static_cast<double>(s.step - told_step_), eta));
    told_ = wall_s;
    told_step_ = s.step;
  } else if (wall_s - shown_ > 0.2) {
    log_.live(fmt::format("{} t {:.4f} of {:g} s  ETA {}", common::progress_bar(s.t_s / end_s_, 40), s.t_s,
                          end_s_, eta));
    shown_ = wall_s;
  }
}

}  // namespace valsalva::run
