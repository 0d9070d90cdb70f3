#!/usr/bin/python3
"""Compares runs and measured beats: compare_runs.py RUN [RUN ...] [--data FILE.csv] [--out DIR] [--html].

Prints a table of the statistics of the last beats and writes it into DIR as metrics.txt, .csv and .md. Draws the traces,
aligned at the opening of the valve, as traces.png and .svg. With --html also writes one page, compare.html.
"""
import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from drawing import style  # noqa: E402
from drawing.run_output import Missing  # noqa: E402
from reporting import comparison, page  # noqa: E402


def distinct_names(folders):
    """The shortest path endings that distinguish the folders."""
    parts = [folder.resolve().parts for folder in folders]
    depth = next((n for n in range(1, 20) if len({p[-n:] for p in parts}) == len(parts)), 1)
    return ["/".join(p[-depth:]) for p in parts]


def html(beats, table, runs, out):
    """The page of a comparison; leaflets appear if the report of a run has drawn them."""
    leaflets = [page.figure(run / "pictures" / "leaflets_above_column.png", beat.name, "Leaflets from the aorta.")
                for run, beat in zip(runs, beats) if (run / "pictures" / "leaflets_above_column.png").is_file()]
    head = ["", *(b.name for b in beats)]
    title = "Comparison of " + ", ".join(head[1:])
    return page.page(title, "".join([
        f"<h1>{page.text(title)}</h1>",
        page.section("Statistics", page.sentences([f"Last beat of each. Percentages are differences from {head[1]}."]),
                     page.grid([page.table(head, [[f"{row[0]}, {row[1]}", *comparison.cells(row)] for row in table],
                                           "side"),
                                page.figure(out / "traces_column.svg", "Last beats",
                                            "Shifted in time so that all valves open at the same instant.")])),
        page.section("Leaflets", page.grid(leaflets)),
    ]))


def compare(runs, data, out, with_html):
    beats = [comparison.beat_of_run(run, name) for run, name in zip(runs, distinct_names(runs))]
    beats += [comparison.beat_of_data(path) for path in data]
    comparison.align(beats)
    table = comparison.rows(beats)
    out.mkdir(parents=True, exist_ok=True)
    print(comparison.as_text(beats, table), end="")
    page.write(out / "metrics.txt", comparison.as_text(beats, table))
    page.write(out / "metrics.md", comparison.as_text(beats, table, markdown=True))
    page.write(out / "metrics.csv", comparison.as_csv(beats, table))
    style.apply()
    comparison.draw(beats, out, "traces", style.PAGE_WIDTH)
    if with_html:
        comparison.draw(beats, out, "traces_column", style.COLUMN_WIDTH)
        page.write(out / "compare.html", html(beats, table, runs, out))
    print(f"compare: {out / ('compare.html' if with_html else 'traces.png')}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", nargs="+", type=Path, help="output folders of runs")
    parser.add_argument("--data", action="append", default=[], type=Path, help="measured beat")
    parser.add_argument("--out", type=Path, default=Path("out/compare"), help="folder for tables and pictures")
    parser.add_argument("--html", action="store_true", help="also write everything as one page")
    arguments = parser.parse_args()
    try:
        compare(arguments.runs, arguments.data, arguments.out, arguments.html)
    except (Missing, OSError) as error:
        print(f"compare: {error}", file=sys.stderr)
        sys.exit(4)


if __name__ == "__main__":
    main()
