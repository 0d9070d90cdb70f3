"""balances: mass-balance error of the 3D domain, and flow through the probe discs minus that through the outlet."""
import matplotlib.pyplot as plt
import numpy as np

from . import style
from .instants import main_flow
from .run_output import Missing, columns_like, read_table


def openings_of_3d(table):
    """(flow in, flow out) of the 3D domain along +z."""
    flows = columns_like(table, r"Q_(.+)_ml_s")
    if not {"inlet", "outlet"} <= flows.keys():
        raise Missing("no inlet and outlet of a 3D domain")
    return flows["inlet"], flows["outlet"]


def integral(t, q):
    """Running trapezoidal integral of q, 0 at the first sample."""
    return np.append(0, np.cumsum(0.5 * (q[1:] + q[:-1]) * np.diff(t)))


def draw(out, pictures):
    table = read_table(out / "openings.csv")
    inflow, outflow = openings_of_3d(table)
    t = table["t_s"]
    figure, (above, below) = plt.subplots(2, 1, sharex=True, figsize=(style.COLUMN_WIDTH, 3.4))
    above.plot(t, 1e3 * integral(t, inflow - outflow), color=style.INK)
    above.set_ylabel("mass-balance\nerror (µl)")
    try:
        probes = read_table(out / "probes.csv")
        q = main_flow(table)[1]
        for name, color in (("upstream", style.VENTRICLE), ("valve", style.AORTA)):
            through = probes[f"Q_{name}_ml_s"]
            n = min(len(through), len(q))
            below.plot(t[:n], through[:n] - q[:n], color=color, linewidth=0.9, label=name)
        below.legend(loc="upper right", ncol=2)
    except (Missing, KeyError):
        below.set_visible(False)
    below.set_ylabel("probe minus\noutlet (ml/s)")
    below.axhline(0, color=style.GREY, linewidth=0.6)
    below.set_xlabel("time (s)")
    below.set_xlim(t[0], max(t[-1], t[0] + 1e-6))
    figure.align_ylabels([above, below])
    figure.tight_layout(pad=0.5)
    style.save(figure, pictures, "balances", "svg")
