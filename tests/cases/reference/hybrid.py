"""An independent integration of circulations with valves: SciPy's DOP853 between events, written for these tests.

A model has `rates(t, y, open)` and, per valve, `drop(t, y, open)` and `flow(t, y, open)`, and `kinks(t)`, the next time at
which a formula changes. A closed valve opens where its drop rises through zero, an open one closes where its flow falls
through zero; `reset(y, valve)` sets the flow of an inertial valve to zero.
"""
import numpy as np
from scipy.integrate import solve_ivp


def integrate(model, y, times, rtol=1e-12, atol=1e-12):
    """States at `times` (increasing, from 0) and the events as (time, valve, opens)."""
    y, t, rows, events = np.array(y, float), 0.0, [np.array(y, float)], []
    is_open = [False] * len(model.valves)
    settle(model, t, y, is_open)
    times = list(times)
    while t < times[-1] - 1e-12:
        stop = min(model.kinks(t), times[-1])

        def margin(valve):
            def f(s, z):
                return model.flow(s, z, is_open, valve) if is_open[valve] else -model.drop(s, z, is_open, valve)
            f.terminal, f.direction = True, -1
            return f

        part = solve_ivp(lambda s, z: model.rates(s, z, is_open), (t, stop), y, "DOP853", rtol=rtol, atol=atol,
                         events=[margin(v) for v in range(len(is_open))], dense_output=True, first_step=min(1e-6, stop - t))
        rows += [part.sol(s) for s in times if t + 1e-13 < s <= part.t[-1] + 1e-13]
        t, y = part.t[-1], part.y[:, -1].copy()
        for valve, at in enumerate(part.t_events):
            if len(at):
                is_open[valve] = not is_open[valve]
                model.reset(y, valve)
                events.append((t, valve, is_open[valve]))
        if not any(len(at) for at in part.t_events):
            t = stop
    return np.array(rows), events


def settle(model, t, y, is_open):
    for _ in range(100):
        wrong = [v for v in range(len(is_open)) if not is_open[v] and model.drop(t, y, is_open, v) > 0]
        if not wrong:
            return
        is_open[wrong[0]] = True


def double_hill(n1, n2, tau1, tau2, period):
    """Activation of one beat, scaled to the maximum 1."""
    def raw(t):
        if t <= 0:
            return 0.0
        h1, h2 = (t / tau1) ** n1, (t / tau2) ** n2
        return h1 / (1 + h1) / (1 + h2)
    from scipy.optimize import minimize_scalar
    best = minimize_scalar(lambda t: -raw(t), bounds=(0, period), method="bounded", options={"xatol": 1e-12})
    return lambda t: raw(t) / -best.fun


def half_cosine(systole):
    return lambda t: 0.5 * (1 - np.cos(2 * np.pi * t / systole)) if t < systole else 0.0


class Chamber:
    """Pressure E(t)(V - V0) from the keys of a [[element]]; `piece` is a time within the current smooth piece."""

    def __init__(self, keys, period):
        self.T, self.keys = period, keys
        get = keys.get
        self.onset = get("onset_periods", 0.0) * period
        if get("activation", "double_hill") == "half_cosine":
            self.systole = get("systole_periods", 0.4) * period
            self.e = half_cosine(self.systole)
        else:
            self.systole = 0.0
            self.e = double_hill(get("n1", 1.32), get("n2", 21.9), get("tau1_periods", 0.303) * period,
                                 get("tau2_periods", 0.508) * period, period)

    def pressure(self, t, V):
        k = self.keys
        e = self.e((t - self.onset) % self.T)
        return (k["Emin_mmHg_ml"] + (k["Emax_mmHg_ml"] - k["Emin_mmHg_ml"]) * e) * (V - k["V0_ml"])

    def kinks(self):
        """Within a period."""
        return {self.onset % self.T, (self.onset + self.systole) % self.T}


def next_kink(t, within, period):
    later = t + 1e-9
    return min(period * (np.floor((later - k) / period) + 1) + k for k in within)
