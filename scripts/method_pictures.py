#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws each stage of both methods on one depth image, for doc/method.md; called by scripts/make_method_pictures.

Each picture has two panels: the published method (preset "paper") and the default one.
"""
import io
import os

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as pyplot  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.collections import LineCollection  # noqa: E402
from PIL import Image  # noqa: E402

from line_plane_segmentation import PlaneSegmenter, color_of  # noqa: E402
from simulated_image import CAMERA, run  # noqa: E402

PANEL = (4.2, 3.15)  # [in] of an image of 640 x 480 pixels
CAPTION = 0.22       # [in] above each panel
DPI = 100
COLOURS = 64         # of a picture's palette
ROW_COLOUR, COLUMN_COLOUR = "#e07000", "#0070d0"
PROFILE_ROW = 300    # [px] the row whose scan is drawn
DETAIL = (160, 120)  # [px] part of the image in which the refinement is shown


class Run:
    """One image, segmented with a preset, and the results of each stage."""

    def __init__(self, depth, preset, **parameters):
        segmenter = PlaneSegmenter(preset, **parameters)
        self.result = segmenter.segment(depth, camera=CAMERA)
        self.lines = segmenter.line_segments
        self.candidates = segmenter.candidates


def new_picture():
    figure, axes = pyplot.subplots(1, 2, figsize=(2 * PANEL[0], PANEL[1] + CAPTION), dpi=DPI)
    figure.subplots_adjust(0.0, 0.0, 1.0, PANEL[1] / (PANEL[1] + CAPTION), wspace=0.01)
    return figure, axes


def show_depth(axes, depth, title):
    metres = np.where(depth > 0, depth, np.nan) / 1000.0
    axes.imshow(np.floor(16.0 * np.clip(metres / 6.0, 0.0, 1.0)), cmap="gray_r", vmin=-6.0, vmax=24.0,
                interpolation="nearest")
    axes.set(xlim=(0, depth.shape[1]), ylim=(depth.shape[0], 0))
    axes.set_title(title, fontsize=9, pad=3)
    axes.axis("off")


def draw_scanlines(depth, paper, default):
    figure, panels = new_picture()
    for axes, run, name in zip(panels, (paper, default), ("paper", "default")):
        rows, columns = (np.unique(run.lines["scanline"][run.lines["direction"] == k]) for k in (0, 1))
        show_depth(axes, depth, "%s: %d rows and %d columns with segments" % (name, len(rows), len(columns)))
        axes.hlines(rows, 0, depth.shape[1], colors=ROW_COLOUR, linewidths=0.6)
        axes.vlines(columns, 0, depth.shape[0], colors=COLUMN_COLOUR, linewidths=0.6)
    return figure


def draw_line_segments(depth, paper, default):
    figure, panels = new_picture()
    for axes, run, name in zip(panels, (paper, default), ("paper", "default")):
        show_depth(axes, depth, "%s: %d line segments" % (name, len(run.lines)))
        for direction, colour in ((0, ROW_COLOUR), (1, COLUMN_COLOUR)):
            lines = run.lines[run.lines["direction"] == direction]
            ends = np.stack([np.stack([lines["first"], lines["scanline"]], 1),
                             np.stack([lines["last"], lines["scanline"]], 1)], 1)
            axes.add_collection(LineCollection(ends if direction == 0 else ends[:, :, ::-1], colors=colour, linewidths=0.9))
    return figure


def draw_profile(depth, paper, default):
    """The scan of one row in inverse depth, and its line segments as fitted: Sx cos(alpha) + Sy sin(alpha) = r."""
    figure, panels = pyplot.subplots(1, 2, figsize=(2 * PANEL[0], 2.2), dpi=DPI, sharey=True)
    figure.subplots_adjust(0.06, 0.18, 0.99, 0.88, wspace=0.05)
    for axes, run, name in zip(panels, (paper, default), ("paper", "default")):
        rows = run.lines["scanline"][run.lines["direction"] == 0]
        row = int(rows[np.argmin(np.abs(rows - PROFILE_ROW))])
        lines = run.lines[(run.lines["direction"] == 0) & (run.lines["scanline"] == row)]
        u = np.arange(depth.shape[1])
        valid = depth[row] > 0
        axes.plot(u[valid], 1000.0 / depth[row][valid], ".", color="#999999", markersize=1.5)
        slope = np.hypot(1.0, (row - CAMERA[3]) / CAMERA[1])
        for k, line in enumerate(lines):
            ends = np.array([line["first"], line["last"]])
            ray = (ends - CAMERA[2]) / CAMERA[0]
            inverse = (slope * np.cos(line["alpha"]) + ray * np.sin(line["alpha"])) / line["r"]
            axes.plot(ends, inverse, "-", color=("#c03020", "#2050c0")[k % 2], linewidth=1.5)
        axes.set_title("%s: row %d, %d segments" % (name, row, len(lines)), fontsize=9, pad=3)
        axes.set_xlabel("column [px]", fontsize=8)
        axes.tick_params(labelsize=7)
    valid = depth[PROFILE_ROW][depth[PROFILE_ROW] > 0]
    panels[0].set_ylim(900.0 / valid.max(), 1100.0 / valid.min())
    panels[0].set_ylabel("inverse depth [1/m]", fontsize=8)
    return figure


def draw_candidates(depth, paper, default):
    """Candidates, coloured by their normals: red for x, green for y, blue for z, as in a normal map."""
    figure, panels = new_picture()
    for axes, run, name in zip(panels, (paper, default), ("paper", "default")):
        show_depth(axes, depth, "%s: %d candidates" % (name, len(run.candidates)))
        normals = np.round(4.0 * (0.5 - 0.5 * run.candidates["normal"])) / 4.0
        axes.scatter(run.candidates["u"], run.candidates["v"], c=np.clip(normals, 0.0, 1.0), s=9, linewidths=0)
    return figure


def draw_extraction(depth, paper, default):
    """Candidates in the colour of the plane that contains their pixel."""
    figure, panels = new_picture()
    for axes, run, name in zip(panels, (paper, default), ("paper", "default")):
        labels = run.result.labels[run.candidates["v"], run.candidates["u"]]
        title = "%s: %d of %d candidates in %d planes" % (name, np.count_nonzero(labels), len(labels), len(run.result.planes))
        show_depth(axes, depth, title)
        palette = np.array([[90, 90, 90]] + [color_of(k) for k in range(1, int(labels.max(initial=0)) + 1)])
        axes.scatter(run.candidates["u"], run.candidates["v"], c=palette[labels] / 255.0, s=9, linewidths=0)
    return figure


def show_labels(axes, depth, run, title):
    show_depth(axes, depth, title)
    labels = run.result.labels
    palette = np.array([[0, 0, 0, 0]] + [color_of(k) + [255] for k in range(1, int(labels.max()) + 1)], np.uint8)
    axes.imshow(palette[labels], interpolation="nearest")


def draw_labels(depth, paper, default):
    figure, panels = new_picture()
    for axes, run, name in zip(panels, (paper, default), ("paper", "default")):
        show_labels(axes, depth, run, "%s: %d planes, %d %% of the valid pixels" % (
            name, len(run.result.planes), round(100.0 * run.result.assigned_pixels / max(1, run.result.valid_pixels))))
    return figure


def draw_refinement(depth, paper, default):
    """The default method without and with the removal of small regions, where it changes most pixels."""
    without = Run(depth, "kinect", min_region_pixels=1)
    changed = (without.result.labels > 0) != (default.result.labels > 0)
    sums = np.pad(changed, ((1, 0), (1, 0))).cumsum(0).cumsum(1)
    width, height = DETAIL
    counts = sums[height:, width:] - sums[:-height, width:] - sums[height:, :-width] + sums[:-height, :-width]
    top, left = np.unravel_index(int(counts.argmax()), counts.shape)
    figure, panels = new_picture()
    show_labels(panels[0], depth, without, "default, min_region_pixels: 1 (detail)")
    show_labels(panels[1], depth, default, "default (detail)")
    for axes in panels:
        axes.set(xlim=(left, left + width), ylim=(top + height, top))
    return figure


def draw_outlines(depth, paper, default):
    figure, panels = new_picture()
    for axes, run, name in zip(panels, (paper, default), ("paper", "default")):
        rings = [(plane.label, ring) for plane in run.result.planes for ring in plane.outlines + plane.holes]
        show_depth(axes, depth, "%s: %d rings, %d vertices" % (name, len(rings), sum(len(ring) for _, ring in rings)))
        for label, ring in rings:
            u = CAMERA[0] * ring[:, 0] / ring[:, 2] + CAMERA[2]
            v = CAMERA[1] * ring[:, 1] / ring[:, 2] + CAMERA[3]
            axes.fill(u, v, fill=False, edgecolor=np.array(color_of(label)) / 300.0, linewidth=1.3)
    return figure


PICTURES = {
    "scanlines": draw_scanlines, "line_segments": draw_line_segments, "profile": draw_profile,
    "candidates": draw_candidates, "extraction": draw_extraction, "labels": draw_labels,
    "refinement": draw_refinement, "outlines": draw_outlines,
}


def write_pictures(depth, folder):
    os.makedirs(folder, exist_ok=True)
    paper, default = Run(depth, "paper"), Run(depth, "kinect")
    for name, draw in PICTURES.items():
        figure = draw(depth, paper, default)
        buffer = io.BytesIO()
        figure.savefig(buffer, format="png", dpi=DPI)
        pyplot.close(figure)
        picture = Image.open(buffer).convert("RGB").quantize(COLOURS, dither=Image.NONE)
        picture.save(os.path.join(folder, name + ".png"), optimize=True)


if __name__ == "__main__":
    run(__doc__, write_pictures)
