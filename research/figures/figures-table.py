#!/usr/bin/python3
"""Writes what scripts/figures.sh measured into docs/figures.md.

Usage: figures-table.py WORK PAGE METHOD..., WORK holding NAME-METHOD.json and NAME-time.json
"""
import json
import pathlib
import sys

# Table 1 of the paper: vertices and faces in thousands, seconds.
PAPER = {"wolf": (32, 52, 10.1), "bunny": (19, 33, 2.7), "farmer": (33, 55, 1.5),
         "unicorn": (22, 36, 3.8), "elephant": (39, 68, 12.4), "lamb": (30, 50, 7.1)}


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def put(page, name, text):
    """Replaces what lies between the page's marks of that name."""
    begin, end = f"<!-- {name} -->\n", f"<!-- end of {name} -->\n"
    head, rest = page.split(begin)
    return head + begin + "\n" + text + "\n" + end + rest.split(end)[1]


def read(path):
    return json.loads(path.read_text())


def times(work):
    rows = []
    for name, (vertices, faces, seconds) in PAPER.items():
        report = read(work / f"{name}-time.json")
        spent = report["timings_ms"]
        solved = sum(spent[stage] for stage in ("mesh", "assemble", "analyse", "inflate", "order"))
        rows.append([name, f"{vertices} k", f"{faces} k", f"{seconds:.1f} s",
                     f"{report['vertices'] / 1000:.0f} k", f"{report['faces'] / 1000:.0f} k",
                     f"{solved / 1000:.2f} s"])
    return table(["model", "vertices, paper", "faces, paper", "time, paper", "vertices", "faces",
                  "time here"], rows)


def measures(work, methods):
    rows = []
    for method in methods:
        reports = [read(work / f"{name}-{method}.json") for name in PAPER]

        def mean(key, part):
            return sum(report[key][part] for report in reports) / len(reports)

        def most(key):
            return max(report[key]["most"] for report in reports)

        rows.append([
            f"`{method}`", f"{mean('slope_jump_degrees', 'median'):.2f}",
            f"{most('slope_jump_degrees'):.1f}", f"{mean('height_jump_px', 'median'):.2f}",
            f"{100 * mean('pit_per_join_length', 'nine_tenths'):.1f}",
            f"{100 * most('pit_per_join_length'):.1f}",
            f"{sum(report['contour_iou'] for report in reports) / len(reports):.3f}",
            f"{sum(report['milliseconds']['method'] for report in reports) / 1000 / len(reports):.2f}",
        ])
    return table(["method", "slope jump, median", "most, degrees", "step, median, px",
                  "pits, 90 %", "most, % of the join", "contour IoU", "time, s"], rows)


def main():
    work, path = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    page = path.read_text()
    page = put(page, "times", times(work))
    page = put(page, "measures", measures(work, sys.argv[3:]))
    path.write_text(page)


main()
