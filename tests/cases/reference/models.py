"""The circulations of the 0D cases, written out by hand for the independent integration."""
import numpy as np

from hybrid import Chamber, next_kink


class LeftHeart:
    """Venous source, resistive mitral valve, ventricle (or a prescribed pressure), aortic valve, Windkessel.

    States V (0 if the pressure is prescribed), Q of the aortic valve (0 without inertance), Pc, volume ejected.
    """
    names = ["ventricle.V_ml", "aortic.Q_ml_s", "arteries.Pc_mmHg", "integral.Q_aortic_ml_s"]
    valves = ["mitral", "aortic"]

    def __init__(self, elements, period):
        self.T, self.e = period, elements
        self.pump = elements["ventricle"]
        self.chamber = Chamber(self.pump, period) if self.pump["type"] == "chamber" else None
        self.L = elements["aortic"].get("L_mmHg_s2_ml", 0.0)
        self.B = elements["aortic"].get("B_mmHg_s2_ml2", 0.0)

    def start(self):
        return [self.pump.get("initial_volume_ml", 0.0), 0.0, self.e["arteries"]["initial_pressure_mmHg"], 0.0]

    def driving(self, t, y):
        """Pressure behind the ventricle's source resistance, and that resistance."""
        if self.chamber:
            return self.chamber.pressure(t, y[0]), self.pump.get("R_mmHg_s_ml", 0.0)
        return np.interp(t, self.pump["time_s"], self.pump["pressure_mmHg"]), 0.0

    def flows(self, t, y, is_open):
        """Mitral and aortic flow and the two nodes' pressures."""
        p, r = self.driving(t, y)
        Pc, Rc, R = y[2], self.e["arteries"]["Rc_mmHg_s_ml"], self.e["aortic"]["R_mmHg_s_ml"]
        mitral = self.e.get("mitral")
        for_mitral = self.e["veins"]["pressure_mmHg"] - p if mitral else 0.0
        Rm = mitral["R_mmHg_s_ml"] if mitral else 1.0
        inertial = self.L > 0
        Qm, Qa = 0.0, y[1] if inertial and is_open[1] else 0.0
        for _ in range(60):  # the two resistive valves share the ventricle's source resistance
            before = Qa
            if is_open[0]:
                Qm = (for_mitral + r * Qa) / (Rm + r)
            if is_open[1] and not inertial:
                dp, total = p + r * Qm - Pc, R + Rc + r
                Qa = 2 * dp / (total + np.sqrt(total**2 + 4 * self.B * abs(dp)))
            if Qa == before:
                break
        return Qm, Qa, p + r * (Qm - Qa), Pc + Rc * Qa

    def rates(self, t, y, is_open):
        a = self.e["arteries"]
        Qm, Qa, p_lv, p_ao = self.flows(t, y, is_open)
        dQ = 0.0
        if self.L > 0 and is_open[1]:
            dQ = (p_lv - p_ao - self.e["aortic"]["R_mmHg_s_ml"] * Qa - self.B * Qa * abs(Qa)) / self.L
        return [Qm - Qa if self.chamber else 0.0, dQ, (Qa - y[2] / a["Rp_mmHg_s_ml"]) / a["C_ml_mmHg"], Qa]

    def drop(self, t, y, is_open, valve):
        _, _, p_lv, p_ao = self.flows(t, y, is_open)
        if valve == 1:
            return p_lv - p_ao
        return self.e["veins"]["pressure_mmHg"] - p_lv if "mitral" in self.e else -1.0

    def flow(self, t, y, is_open, valve):
        return y[1] if valve == 1 and self.L > 0 else self.flows(t, y, is_open)[valve]

    def reset(self, y, valve):
        if valve == 1:
            y[1] = 0.0

    def kinks(self, t):
        if self.chamber:
            return next_kink(t, self.chamber.kinks(), self.T)
        return min([k for k in self.pump["time_s"] if k > t + 1e-9], default=np.inf)


class FourChambers:
    """cases/four_chamber_loop: four chambers, four valves, five vessels with the compliance at their inlet."""
    valves = ["mitral", "aortic", "tricuspid", "pulmonary"]
    names = ["lv.V_ml", "rv.V_ml", "la.V_ml", "ra.V_ml", "aortic.Q_ml_s", "pulmonary.Q_ml_s", "aorta.Q_ml_s",
             "aorta.P_mmHg", "body.P_mmHg", "veins.P_mmHg", "lungs.P_mmHg", "lung_veins.P_mmHg", "integral.Q_aortic_ml_s"]
    compliances = ["aorta", "body", "veins", "lungs", "lung_veins"]

    def __init__(self, elements, period):
        self.T, self.e = period, elements
        self.chambers = [Chamber(elements[name], period) for name in ("lv", "rv", "la", "ra")]
        self.within = set().union(*(c.kinks() for c in self.chambers))

    def start(self):
        return ([self.e[n]["initial_volume_ml"] for n in ("lv", "rv", "la", "ra")] + [0.0] * 3
                + [self.e[n]["initial_pressure_mmHg"] for n in self.compliances] + [0.0])

    def pressures(self, t, y, is_open):
        """Pressures of lv, rv, la, ra and the flows of mitral and tricuspid; only lv has a source resistance."""
        lv, rv, la, ra = (c.pressure(t, V) for c, V in zip(self.chambers, y[:4]))
        r, Qa = self.e["lv"].get("R_mmHg_s_ml", 0.0), y[4] if is_open[1] else 0.0
        Qm = (la - lv + r * Qa) / (self.e["mitral"]["R_mmHg_s_ml"] + r) if is_open[0] else 0.0
        Qt = (ra - rv) / self.e["tricuspid"]["R_mmHg_s_ml"] if is_open[2] else 0.0
        return lv + r * (Qm - Qa), rv, la, ra, Qm, Qt

    def rates(self, t, y, is_open):
        lv, rv, la, ra, Qm, Qt = self.pressures(t, y, is_open)
        Qa, Qp, Q = y[4] if is_open[1] else 0.0, y[5] if is_open[3] else 0.0, y[6]
        p = dict(zip(self.compliances, y[7:12]))

        def R(name):
            return self.e[name]["R_mmHg_s_ml"]

        def valve(name, dp, q, opened):
            k = self.e[name]
            return (dp - k["R_mmHg_s_ml"] * q - k.get("B_mmHg_s2_ml2", 0.0) * q * abs(q)) / k["L_mmHg_s2_ml"] if opened else 0

        body, veins = (p["body"] - p["veins"]) / R("body"), (p["veins"] - ra) / R("veins")
        lungs, lung_veins = (p["lungs"] - p["lung_veins"]) / R("lungs"), (p["lung_veins"] - la) / R("lung_veins")
        net = {"aorta": Qa - Q, "body": Q - body, "veins": body - veins, "lungs": Qp - lungs, "lung_veins": lungs - lung_veins}
        return ([Qm - Qa, Qt - Qp, lung_veins - Qm, veins - Qt,
                 valve("aortic", lv - p["aorta"], Qa, is_open[1]), valve("pulmonary", rv - p["lungs"], Qp, is_open[3]),
                 (p["aorta"] - p["body"] - R("aorta") * Q) / self.e["aorta"]["L_mmHg_s2_ml"]]
                + [net[name] / self.e[name]["C_ml_mmHg"] for name in self.compliances] + [Qa])

    def drop(self, t, y, is_open, valve):
        lv, rv, la, ra, _, _ = self.pressures(t, y, is_open)
        return (la - lv, lv - y[7], ra - rv, rv - y[10])[valve]

    def flow(self, t, y, is_open, valve):
        _, _, _, _, Qm, Qt = self.pressures(t, y, is_open)
        return (Qm, y[4], Qt, y[5])[valve]

    def reset(self, y, valve):
        if valve in (1, 3):
            y[4 if valve == 1 else 5] = 0.0

    def kinks(self, t):
        return next_kink(t, self.within, self.T)
