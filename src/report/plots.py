# SPDX-License-Identifier: BSD-3-Clause
"""Plots with matplotlib, as PNG."""

import io

import matplotlib
import PIL.Image

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

import tables  # noqa: E402

OURS, BASELINE = "#288c50", "#1e6ebe"


def png_of(figure):
    """The figure without matplotlib's alpha channel, which an opaque picture does not need."""
    rendered, encoded = io.BytesIO(), io.BytesIO()
    figure.savefig(rendered, format="png", dpi=100)
    pyplot.close(figure)
    PIL.Image.open(rendered).convert("RGB").save(encoded, "PNG")
    return encoded.getvalue()


def fraction(part, whole):
    return part / whole if whole else 0.0


def curve(data):
    """How a set's regions were classified over the tolerance, as Hoover et al. plot it: fractions of the required
    ground truth regions, which add up to 1, and noise as a fraction of the label regions.
    data: the JSON of evaluate_segmentation"""
    series = [("correct", "#288c50", "truth_regions"), ("over_segmented", "#1e6ebe", "truth_regions"),
              ("merged", "#8c46a0", "truth_regions"), ("missed", "#d23232", "truth_regions"),
              ("noise", "#e6961e", "label_regions")]
    shown_names = {"merged": "under-segmented", "over_segmented": "over-segmented"}
    figure, axes = pyplot.subplots(figsize=(9.6, 5.6), constrained_layout=True)
    for name, color, whole in series:
        label = "%s  %.2f" % (shown_names.get(name, name), fraction(data["set"][name], data["set"][whole]))
        axes.plot([point["tolerance"] for point in data["curve"]],
                  [fraction(point[name], point[whole]) for point in data["curve"]], color=color, label=label)
    axes.axvline(data["tolerance"], color="0.6", linewidth=1)
    axes.set(xlim=(0.5, 1), ylim=(-0.01, 1.01), xlabel="tolerance", ylabel="fraction of the regions")
    axes.grid(color="0.9")
    legend = axes.legend(title="at tolerance %.3g" % data["tolerance"], loc="upper left", bbox_to_anchor=(1.01, 1))
    legend.set_in_layout(True)
    axes.text(1.03, 0.4, "%d ground truth regions\n%d label regions" %
              (data["set"]["truth_regions"], data["set"]["label_regions"]), transform=axes.transAxes, fontsize=9)
    return png_of(figure)


def times(data):
    """Times of the methods on the frames of the first measurement's size, one panel for each frame: from the smallest
    to the largest time on a logarithmic axis, the median as a dot."""
    size = (data["frames"][0]["width"], data["frames"][0]["height"])
    shown = [m for m in data["frames"] if (m["width"], m["height"]) == size]
    names = list(dict.fromkeys(m["frame"] for m in shown))
    heights = [sum(m["frame"] == name for m in shown) for name in names]
    figure, panels = pyplot.subplots(len(names), 1, sharex=True, squeeze=False, constrained_layout=True,
                                     figsize=(9.6, 0.6 + 0.35 * len(names) + 0.22 * len(shown)),
                                     gridspec_kw={"height_ratios": heights})
    for name, axes in zip(names, panels[:, 0]):
        rows = [m for m in shown if m["frame"] == name]
        for row, measured in enumerate(rows):
            total, color = measured["total"], OURS if measured["stages"] else BASELINE
            axes.plot([total["min"], total["max"]], [row, row], color=color, linewidth=2.5)
            axes.plot(total["median"], row, "o", color=color, markersize=6)
            axes.annotate(tables.three_digits(total["median"]), (total["max"], row), xytext=(8, 0), textcoords="offset points",
                          va="center", fontsize=8)
        axes.set_yticks(range(len(rows)))
        axes.set_yticklabels([m["method"] for m in rows], fontsize=9)
        axes.set(ylim=(len(rows) - 0.5, -0.5), xscale="log", xlim=(0.1, 1e4))
        axes.set_title(name, loc="left", fontsize=10)
        axes.grid(axis="x", color="0.9")
    panels[-1, 0].set_xlabel("time [ms]")
    return png_of(figure)
