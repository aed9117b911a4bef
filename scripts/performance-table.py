#!/usr/bin/env python3
"""Writes the measurements of relievo_benchmark into docs/performance.md.

Usage: performance-table.py ONE.json ALL.json, made with relievo_benchmark --benchmark_out=..., the
first with --threads=1 for processor times, the second without for wall times
"""
import json
import pathlib
import sys

PAGE = pathlib.Path(__file__).parent.parent / "docs" / "performance.md"
BEGIN, END = "<!-- measured -->\n", "<!-- end -->\n"


def read(path):
    """Benchmarks by their name without Google Benchmark's suffixes."""
    results = {}
    for run in json.loads(pathlib.Path(path).read_text())["benchmarks"]:
        if run.get("run_type") == "aggregate" and run.get("aggregate_name") != "median":
            continue
        if not run.get("error_occurred"):
            results["/".join(run["run_name"].split("/")[:3])] = run
    return results


def ms(results, name):
    run = results.get(name)
    return "" if run is None else f"{run['cpu_time']:.3g}"


def wall_ms(results, name):
    run = results.get(name)
    return "" if run is None else f"{run['real_time']:.3g}"


def ratio(results, name, baseline, time="cpu_time"):
    run, other = results.get(name), results.get(baseline)
    return "" if run is None or other is None else f"{run[time] / other[time]:.3g}"


def count(results, name, counter):
    run = results.get(name)
    return "" if run is None or counter not in run else f"{run[counter]:.0f}"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def sizes(results, stage):
    return sorted({tuple(name.split("/")[1:]) for name in results if name.startswith(stage + "/")},
                  key=lambda size: (int(size[1]), size[0]))


def stages(results):
    columns = ["mesh", "discretise", "inflate", "order", "order_cold", "solve", "build", "model"]
    rows = []
    for size in sizes(results, "solve"):
        name = "/".join(size)
        rows.append([size[0], size[1]] + [ms(results, f"{stage}/{name}") for stage in columns] +
                    [count(results, f"order/{name}", "iterations"),
                     count(results, f"order_cold/{name}", "iterations")])
    return table(["drawing", "vertices"] + columns + ["iterations", "cold"], rows)


def solids(results):
    rows = []
    for size in sizes(results, "figure"):
        name = "/".join(size)
        row = [size[0], size[1]]
        for kind in ["solid", "figure", "mirrored"]:
            row += [ms(results, f"{kind}/{name}"), count(results, f"{kind}/{name}", "triangles")]
        rows.append(row)
    return table(["drawing", "vertices", "solid", "triangles", "figure", "triangles", "a leg mirrored",
                  "triangles"], rows)


def references(results):
    rows = []
    for size in sizes(results, "cholmod"):
        name = "/".join(size)
        rows.append([size[0], size[1], ms(results, f"cholmod/{name}"),
                     ratio(results, f"cholmod/{name}", f"factor/{name}"),
                     ratio(results, f"solve/{name}", f"cholmod/{name}"),
                     ratio(results, f"interior_point/{name}", f"order_cold/{name}"),
                     ratio(results, f"multipliers/{name}", f"solve/{name}")])
    return table(["drawing", "vertices", "CHOLMOD, ms", "CHOLMOD / own", "solve / CHOLMOD",
                  "interior point / order", "multipliers / solve"], rows)


def walls(results):
    columns = ["mesh", "discretise", "inflate", "order", "solve", "build", "model"]
    rows = []
    for drawing, vertices in sizes(results, "solve"):
        name = f"{drawing}/{vertices}"
        rows.append([drawing, vertices] + [wall_ms(results, f"{stage}/{name}") for stage in columns] +
                    [ratio(results, f"solve/{name}", f"cholmod/{name}", "real_time"),
                     ratio(results, f"multipliers/{name}", f"solve/{name}", "real_time")])
    return table(["drawing", "vertices"] + columns + ["solve / CHOLMOD", "multipliers / solve"],
                 rows)


def edits(results, threaded):
    rows = []
    for name, run in sorted(results.items()):
        if name.startswith("edit/"):
            _, drawing, edit = name.split("/")
            changes = int(run["changes"])
            rows.append([drawing, edit.replace("_", " "), f"{run['cpu_time']:.3g}",
                         wall_ms(threaded, name),
                         "other mesh" if changes < 0 else str(changes),
                         f"{run['iterations']:.0f}"])
    return table(["drawing", "edit", "ms", "wall ms", "gaps that open or close", "iterations"], rows)


def nonlinear(results, threaded):
    rows = []
    for bound in ("100", "0.01"):
        for drawing, vertices in sizes(results, f"nonlinear_{bound}"):
            name = f"nonlinear_{bound}/{drawing}/{vertices}"
            run, wall = results[name], threaded.get(name)
            rows.append([drawing, vertices, bound, f"{run['steps']:.0f}",
                         f"{run['processor_ms']:.3g}", f"{run['ratio']:.2g}",
                         f"{wall['wall_ms']:.3g}" if wall else "",
                         f"{wall['wall_ratio']:.2g}" if wall else ""])
    return table(["drawing", "vertices", "λ_bnd", "steps", "ms", "non-linear / approximate",
                  "wall ms", "wall ratio"], rows)


def descents(results):
    rows = []
    for drawing, vertices in sizes(results, "descent_100"):
        run = results[f"descent_100/{drawing}/{vertices}"]
        rows.append([drawing, vertices, f"{run['cpu_time'] / 1000:.3g}", f"{run['ratio']:.2g}",
                     f"{run['error']:.2g}", f"{run['violation']:.1g}"])
    return table(["drawing", "vertices", "s", "descent / own", "error of the energy",
                  "violation"], rows)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    results, threaded = read(sys.argv[1]), read(sys.argv[2])
    page = PAGE.read_text()
    before, rest = page.split(BEGIN)
    _, after = rest.split(END)
    parts = [("Stages, ms", stages(results)),
             ("Wall times with a thread for each of two cores, ms", walls(threaded)),
             ("Solids and figures, ms", solids(results)),
             ("References", references(results)),
             ("Edits at 40,000 vertices", edits(results, threaded)),
             ("Non-linear, operators and inflation included", nonlinear(results, threaded)),
             ("L-BFGS on an augmented Lagrangian, λ_bnd = 100", descents(results))]
    body = "\n".join(f"### {title}\n\n{text}" for title, text in parts if text.count("\n") > 2)
    PAGE.write_text(before + BEGIN + "\n" + body + "\n" + END + after)


main()
