#!/usr/bin/env python3
"""plot.py DIRECTORY: the picture of a study, DIRECTORY/study.png, from DIRECTORY/study.json."""

import json
import pathlib
import sys

import matplotlib
import matplotlib.colors
import matplotlib.ticker

matplotlib.use("Agg")
import matplotlib.pyplot as plt

plt.rcParams.update({"font.size": 9, "axes.grid": True, "grid.alpha": 0.3, "lines.markersize": 4, "legend.fontsize": 8,
                     "figure.dpi": 160, "axes.spines.top": False, "axes.spines.right": False})

MARKERS = "osD^v<>pPX*h"


def positive(xs, ys):
    """The points with a number that a logarithmic axis can show."""
    pairs = [(x, y) for x, y in zip(xs, ys) if y is not None and y > 0]
    return [x for x, _ in pairs], [y for _, y in pairs]


def convergence(study, figure):
    """Errors over the spacing, a panel a norm, with the slopes of orders 1 and 2."""
    h = [level["spacing"] for level in study["levels"]]
    quantities = [q for q in study["quantities"] if q["principal"]]
    panels = figure.subplots(1, 3, sharex=True)
    for norm, title, axes in zip(("l1", "l2", "max"), ("$L_1$", "$L_2$", "max"), panels):
        lowest = highest = None
        for k, quantity in enumerate(quantities):
            xs, ys = positive(h, quantity[norm])
            if not xs:
                continue
            order = quantity[norm + "_order"]
            label = quantity["heading"] + (f"  {order:.2f}" if order is not None else "")
            axes.loglog(xs, ys, marker=MARKERS[k % len(MARKERS)], label=label)
            lowest = min(ys) if lowest is None else min(lowest, *ys)
            highest = max(ys) if highest is None else max(highest, *ys)
        if lowest is not None:
            for order, style in ((1, ":"), (2, "--")):
                top = highest * 1.6
                axes.loglog(h, [top * (x / max(h)) ** order for x in h], style, color="0.4", lw=1)
                axes.annotate(f"{order}", (min(h), top * (min(h) / max(h)) ** order), color="0.4",
                              textcoords="offset points", xytext=(-8, -2))
        axes.xaxis.set_minor_locator(matplotlib.ticker.NullLocator())
        axes.set_xticks(h, [f"{x:.3g}" for x in h])
        difference = study["against"] == "self"
        axes.set(title=title, xlabel="h" if study["vary"] == "grid.factor" else f"1/{study['vary']}",
                 ylabel="difference of successive levels" if difference else "error")
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.16), ncol=2, frameon=False)
    figure.suptitle(f"{study['case']}: convergence (fitted orders beside the names; grey: orders 1 and 2)")


def cost(study, figure):
    """Error over run time and over cell updates, a curve a configuration; the Pareto front ringed."""
    names = list(dict.fromkeys(p["configuration"] for p in study["points"]))
    panels = figure.subplots(1, 2, sharey=True)
    for axes, key, title in zip(panels, ("seconds", "cell_updates"), ("seconds (median, least to most)", "cell updates")):
        for k, name in enumerate(names):
            points = [p for p in study["points"] if p["configuration"] == name]
            good = [p for p in points if p["status"] == "finished" and p["error"]]
            label = name if good else name + " (unstable)"
            x, y = [p[key] for p in good], [p["error"] for p in good]
            color = f"C{k % 10}"
            axes.loglog(x, y, marker=MARKERS[k % len(MARKERS)], label=label, color=color)
            if key == "seconds" and good:
                spread = [[p["seconds"] - p["least_seconds"] for p in good], [p["most_seconds"] - p["seconds"] for p in good]]
                axes.errorbar(x, y, xerr=spread, fmt="none", color=color, lw=0.8)
            if key == "seconds":
                front = [p for p in good if p["pareto"]]
                axes.plot([p[key] for p in front], [p["error"] for p in front], "o", ms=10, mfc="none", mec="k", mew=0.8)
        axes.set(xlabel=title)
    panels[0].set(ylabel="relative $L_1$ error")
    panels[1].legend(loc="upper left", bbox_to_anchor=(1, 1), frameon=False)
    figure.suptitle(f"{study['case']}: run time against error (ringed: Pareto front)")


def stability(study, figure):
    """Growth per step over the impedance ratio, measured on theory; below, theory over ratio and Courant number."""
    maps = study["maps"]
    columns = max(1, min(4, len(maps)))
    rows = -(-len(maps) // columns)
    layout = figure.add_gridspec(1 + rows, columns, height_ratios=[1.5] + [1] * rows)
    panels = []
    axes = figure.add_subplot(layout[0, :])
    for k, scheme in enumerate(dict.fromkeys(p["scheme"] for p in study["points"])):
        points = sorted((p for p in study["points"] if p["scheme"] == scheme), key=lambda p: p["value"])
        measured = [p for p in points if p["measured"] is not None]
        axes.plot([p["value"] for p in measured], [p["measured"] for p in measured], MARKERS[k % len(MARKERS)],
                  color=f"C{k % 10}", mfc="none", label=scheme)
        theory = [p for p in points if p["predicted"] is not None]
        axes.plot([p["value"] for p in theory], [p["predicted"] for p in theory], "-", color=f"C{k % 10}", lw=0.9)
    axes.axhline(1, color="0.4", lw=0.8)
    axes.set(xscale="log", yscale="log", xlabel=study["vary"], ylabel="growth per step",
             title="small disturbances: measured (symbols), amplification matrix (lines)")
    axes.legend(loc="upper center", ncol=3)
    image = None
    for k, one in enumerate(maps):
        panel = figure.add_subplot(layout[1 + k // columns, k % columns])
        factors = [[min(max(f if f is not None else 1e3, 1e-3), 1e3) for f in one["factor"][i * len(one["cfl"]):(i + 1) * len(one["cfl"])]]
                   for i in range(len(one["ratio"]))]
        values = [list(row) for row in zip(*factors)]
        panel.grid(False)
        image = panel.pcolormesh(one["ratio"], one["cfl"], [[f - 1 for f in row] for row in values],
                                 norm=matplotlib.colors.SymLogNorm(0.02, vmin=-10, vmax=10), cmap="RdBu_r", shading="nearest")
        if min(map(min, values)) < 1 + 3e-4 < max(map(max, values)):
            panel.contour(one["ratio"], one["cfl"], values, levels=[1 + 3e-4], colors="k", linewidths=1)
        panel.set(xscale="log", title=one["scheme"], xlabel=study["ratio"], ylabel="CFL", xlim=(one["ratio"][0], one["ratio"][-1]))
        panels.append(panel)
    if image is not None:
        figure.colorbar(image, ax=panels, label="growth per step $-$ 1", shrink=0.8)
    figure.suptitle(f"{study['case']}: stability")


def stress(study, figure):
    """How many random scenes of each kind ended how."""
    axes = figure.subplots()
    colors = {"passed": "#4c9f70", "refused": "#c0c0c0", "numerical": "#e0a030"}
    left = [0] * len(study["kinds"])
    for verdict in study["verdicts"]:
        counts = [kind["counts"].get(verdict, 0) for kind in study["kinds"]]
        if any(counts):
            axes.barh([kind["kind"] for kind in study["kinds"]], counts, left=left, label=verdict, color=colors.get(verdict, "#b03030"))
        left = [a + b for a, b in zip(left, counts)]
    axes.set(xlabel="random scenes", title=f"stress study, seeds {study['first']} to {study['last']}")
    axes.legend(frameon=False, loc="upper left", bbox_to_anchor=(1, 1))


KINDS = {"convergence": (convergence, (13, 5.4)), "cost": (cost, (11, 4.6)),
         "stability": (stability, (12, 9)), "stress": (stress, (9, 4.5))}


def main():
    directory = pathlib.Path(sys.argv[1])
    study = json.loads((directory / "study.json").read_text())
    draw, size = KINDS[study["kind"]]
    figure = plt.figure(figsize=size, layout="constrained")
    draw(study, figure)
    figure.savefig(directory / "study.png")


if __name__ == "__main__":
    main()
