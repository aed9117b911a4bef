#!/usr/bin/env python3
"""Writes the measurements of relievo_benchmark into docs/performance.md.

Usage: performance-table.py RUN.json..., each made with relievo_benchmark --threads=1
--benchmark_out=RUN.json; a later run replaces what it measures again
"""
import json
import pathlib
import statistics
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


def ratio(results, name, baseline):
    run, other = results.get(name), results.get(baseline)
    return "" if run is None or other is None else f"{run['cpu_time'] / other['cpu_time']:.3g}"


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
    columns = ["mesh", "discretise", "inflate", "order", "solve", "build", "model"]
    rows = []
    for size in sizes(results, "solve"):
        name = "/".join(size)
        if size[0] == "wolf" or size[1] == "40000":
            rows.append([size[0], size[1]] + [ms(results, f"{stage}/{name}") for stage in columns] +
                        [count(results, f"order/{name}", "iterations")])
    return table(["drawing", "vertices"] + columns + ["iterations"], rows)


def solids(results):
    columns = ["solid", "figure", "mirrored"]
    rows = [[drawing, vertices] + [ms(results, f"{kind}/{drawing}/{vertices}") for kind in columns]
            for drawing, vertices in sizes(results, "figure")]
    return table(["drawing", "vertices", "solid", "figure", "a leg mirrored"], rows)


def references(results):
    rows = []
    for size in sizes(results, "factor"):
        name = "/".join(size)
        rows.append([size[0], size[1]] +
                    [ms(results, f"{method}/{name}")
                     for method in ("factor", "eigen", "cholmod_simplicial", "cholmod_choice")] +
                    [ratio(results, f"interior_point/{name}", f"order_cold/{name}"),
                     ratio(results, f"multipliers/{name}", f"solve/{name}")])
    return table(["drawing", "vertices", "own, ms", "Eigen", "CHOLMOD, simplicial",
                  "CHOLMOD, its choice", "interior point / order", "multipliers / solve"], rows)


def edits(results):
    """Over the drawings."""
    runs = {}
    for name, run in results.items():
        if name.startswith("edit/"):
            runs.setdefault(name.split("/")[2], []).append(run)
    rows = []
    for edit, found in sorted(runs.items()):
        times = [run["cpu_time"] for run in found]
        rows.append([edit.replace("_", " "), f"{statistics.median(times):.3g}", f"{max(times):.3g}",
                     "yes" if any(run["changes"] < 0 for run in found) else ""])
    return table(["edit", "ms, median", "most", "other mesh"], rows)


def nonlinear(results):
    rows = []
    for drawing, vertices in sizes(results, "nonlinear_100"):
        row = [drawing, vertices]
        for bound in ("100", "0.01"):
            run = results[f"nonlinear_{bound}/{drawing}/{vertices}"]
            row += [f"{run['steps']:.0f}", f"{run['processor_ms']:.3g}", f"{run['ratio']:.2g}"]
        rows.append(row)
    return table(["drawing", "vertices", "steps, 100", "ms", "ratio", "steps, 0.01", "ms", "ratio"],
                 rows)


def descents(results):
    rows = []
    for drawing, vertices in sizes(results, "descent_100"):
        run = results[f"descent_100/{drawing}/{vertices}"]
        rows.append([drawing, vertices, f"{run['cpu_time'] / 1000:.3g}", f"{run['ratio']:.2g}",
                     f"{run['error']:.2g}", f"{run['violation']:.1g}"])
    return table(["drawing", "vertices", "s", "descent / own", "error of the energy",
                  "violation"], rows)


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    results = {}
    for path in sys.argv[1:]:
        results.update(read(path))
    page = PAGE.read_text()
    before, rest = page.split(BEGIN)
    _, after = rest.split(END)
    parts = [("Stages, ms", stages(results)),
             ("Edits at 40,000 vertices", edits(results)),
             ("Factorisations of the order's matrix, and other methods", references(results)),
             ("Non-linear method with λ_bnd = 100 and 0.01", nonlinear(results)),
             ("L-BFGS on an augmented Lagrangian, λ_bnd = 100", descents(results)),
             ("Solids and figures, ms", solids(results))]
    body = "\n".join(f"### {title}\n\n{text}" for title, text in parts if text.count("\n") > 2)
    PAGE.write_text(before + BEGIN + "\n" + body + "\n" + END + after)


main()
