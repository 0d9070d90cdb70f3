"""What the recorded cases read: the cases of this folder, a made-up beat and a small set of fibre files.

Only + - * / and fixed decimals, so that every machine writes the same files.
"""
import shutil
from pathlib import Path

CASES = Path(__file__).resolve().parent / "cases"
PERIOD_S, INTERVAL_S, EJECTION_S, STROKE_ML = 0.8, 0.005, 0.3, 70.0
NODES = 13  # along each side of the sheet


def write_inputs(folder, measured=None):
    """Fills `folder`; `measured` is a CSV of a measured beat or None."""
    folder.mkdir()
    for case in sorted(CASES.glob("*.toml")):
        shutil.copy(case, folder)
    (folder / "beat.csv").write_text(beat_csv())
    if measured:
        shutil.copy(measured, folder / "measured.csv")
    for ending, lines in sheet().items():
        text = "\n".join([str(len(lines)), *lines]) + "\n"
        (folder / f"sheet.{ending}").write_text(text)
        if ending in ("vertex", "spring", "beam"):  # as a sheet, but nothing holds it, and its beams have equal sides
            (folder / f"raft.{ending}").write_text(text)


def beat_csv():
    """Flow of an ejection and the pressure of a three-element Windkessel behind it (Rc 0.04, Rp 0.9, C 1.5), the 21st beat, with some noise."""
    per_sample = 20
    dt = INTERVAL_S / per_sample
    samples = round(PERIOD_S / INTERVAL_S)
    pc, rows = 80.0, []
    for n in range(21 * samples * per_sample):
        s = n % (samples * per_sample) * dt / EJECTION_S
        q = 6 * STROKE_ML / EJECTION_S * s * (1 - s) if s < 1 else 0.0
        if n >= 20 * samples * per_sample and n % per_sample == 0:
            rows.append(f"{len(rows) * INTERVAL_S:.3f},{q:.4f},{pc + 0.04 * q + 0.1 * (37 * len(rows) % 11 - 5):.4f}")
        pc += dt / 1.5 * (q - pc / 0.9)
    return "t_s,Q_ao_ml_s,p_ao_mmHg\n" + "\n".join(rows) + "\n"


def sheet():
    """A square of fibres in a plane across z, slightly curved: springs of both kinds, beams, tethers at two edges."""
    def node(i, j):
        return i * NODES + j

    def position(i, j):
        a, b = i / (NODES - 1), j / (NODES - 1)
        return 0.6 + 0.8 * a, 0.6 + 0.8 * b, 2.0 + 0.8 * a * (1 - a) * b * (1 - b)

    every = [(i, j) for i in range(NODES) for j in range(NODES)]
    rest = 0.8 / (NODES - 1)
    springs, beams = [], []
    for i, j in every:
        for di, dj in [(1, 0), (0, 1)]:
            if i + di < NODES and j + dj < NODES:
                springs.append(f"{node(i, j)} {node(i + di, j + dj)} 2000.0 {rest:.9f} 0")
            if i + 2 * di < NODES and j + 2 * dj < NODES:
                beams.append(f"{node(i, j)} {node(i + di, j + dj)} {node(i + 2 * di, j + 2 * dj)} 50.0")
        if i + 1 < NODES and j + 1 < NODES:
            springs.append(f"{node(i, j)} {node(i + 1, j + 1)} 1000.0 {1.4 * rest:.9f} 1")
    return {
        "vertex": ["{:.9f} {:.9f} {:.9f}".format(*position(i, j)) for i, j in every],
        "spring": springs,
        "beam": beams,
        "beam_lengths": [f"{rest:.9f} {1.1 * rest:.9f}" for _ in beams],
        "target": [f"{node(i, j)} 5000.0" for i, j in every if i in (0, NODES - 1)],
    }
