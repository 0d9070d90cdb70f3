#!/usr/bin/python3
"""Draws a fit: draw_fit.py OUT writes OUT/fit.png and fit.svg, data and model above, residuals below."""
import json
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))
from drawing import style  # noqa: E402
from drawing.run_output import Missing, read_table  # noqa: E402

import matplotlib.pyplot as plt  # noqa: E402


def label_of(signal):
    """'p_ao_mmHg' -> 'pressure (mmHg)', 'Q_ao_ml_s' -> 'flow (ml/s)'; other columns keep their name."""
    if signal.endswith("_mmHg"):
        return "pressure (mmHg)"
    return "flow (ml/s)" if signal.endswith("_ml_s") else signal


def estimate_text(estimate):
    sd = "not determined" if estimate["sd"] is None else f"\u00b1 {estimate['sd']:.2g}"
    return f"{estimate['name']}  {estimate['value']:.4g} {sd}"


def draw(out):
    table = read_table(out / "fit.csv")
    result = json.loads((out / "fit.json").read_text())
    signals = [name.removeprefix("data_") for name in table if name.startswith("data_")]
    if not signals:
        raise Missing("no traces in fit.csv")
    figure, axes = plt.subplots(2, len(signals), figsize=(style.PAGE_WIDTH * (0.62 if len(signals) == 1 else 1), 3.8),
                                sharex=True, squeeze=False, height_ratios=[3, 1], layout="constrained")
    for (above, below), signal in zip(axes.T, signals):
        above.plot(table["t_s"], table["data_" + signal], "o", ms=2.2, color=style.GREY, label="data")
        above.plot(table["t_s"], table["model_" + signal], color=style.AORTA, label="model")
        above.set_ylabel(label_of(signal))
        above.legend(loc="upper right")
        below.axhline(0, color=style.GREY, lw=0.6)
        below.plot(table["t_s"], table["residual_" + signal], color=style.VENTRICLE, lw=1)
        below.set_ylabel("model \u2212 data")
        below.set_xlabel("time (s)")
    lines = "\n".join(estimate_text(e) for e in result["estimates"])
    figure.suptitle(lines, fontsize=8, ha="left", x=0.02)
    style.save(figure, out, "fit", "svg")


def main():
    if len(sys.argv) != 2 or not Path(sys.argv[1]).is_dir():
        sys.exit(__doc__)
    style.apply()
    try:
        draw(Path(sys.argv[1]))
    except Missing as missing:
        print(f"fit: skipped, {missing}")


if __name__ == "__main__":
    main()
