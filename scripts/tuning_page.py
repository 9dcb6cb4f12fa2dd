#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes a page with a picture of the effect of each parameter of the method; called by scripts/make_tuning_page.

Each picture shows the planes of the same image for a smaller, the default and a larger value.
"""
import os
import re

import numpy as np
from PIL import Image, ImageDraw

from line_plane_segmentation import PlaneSegmenter
from line_plane_segmentation.cfg import PlaneSegmenterConfig
from simulated_image import CAMERA, run

PANEL = (213, 160)  # [px]
GAP = 3
CAPTION = 14
FACTOR = 4.0  # from the default to the smaller and the larger value

# Values for parameters whose default is 0, or for which multiples of the default are not instructive.
VALUES = {
    "scanline_spacing": (6, 0, 40), "line_window": (3, 0, 31), "min_line_points": (2, 0, 90),
    "points_per_segment": (1, 3, 5), "normal_window": (8, 0, 60), "min_window_points": (20, 0, 1500),
    "min_plane_inliers": (300, 0, 20000), "min_plane_area": (0.0, 0.2, 1.0), "min_region_pixels": (10, 0, 3000),
    "min_range": (0.3, 1.5, 2.5), "max_range": (2.0, 3.0, 10.0), "min_patches": (1, 3, 30),
}
SKIPPED = {"method"}  # shown by the presets


def read_parameters():
    """Yields group, name, description, default, lowest and highest value of each parameter."""
    def walk(group, name):
        for parameter in group["parameters"]:
            yield (name, parameter["name"], parameter["description"], parameter["default"], parameter["min"],
                   parameter["max"])
        for inner in group["groups"]:
            yield from walk(inner, inner["name"])
    yield from walk(PlaneSegmenterConfig.config_description, "method")


def palette(index):
    hue = 0.61803 * index % 1.0
    ramps = np.clip(np.abs((hue * 6.0 + np.array([0.0, 4.0, 2.0])) % 6.0 - 3.0) - 1.0, 0.0, 1.0)
    return 60.0 + 180.0 * ramps


def colours_of(labels, reference):
    """Returns the colours per label: that of the reference plane with the most common pixels."""
    colours = np.zeros((int(labels.max()) + 1, 3))
    taken = set()
    for label in range(1, len(colours)):
        votes = np.bincount(reference[labels == label], minlength=1)
        votes[0] = 0
        index = int(votes.argmax()) if votes.any() else 0
        if index == 0 or index in taken:
            index = 100 + label
        taken.add(index)
        colours[label] = palette(index)
    return colours


def overlay(depth, labels, reference):
    grey = np.where(depth > 0, 255.0 - 200.0 * np.clip(depth / 5000.0, 0.0, 1.0), 0.0)[..., None]
    tint = colours_of(labels, reference)[labels]
    shown = np.where((labels > 0)[..., None], 0.4 * grey + 0.6 * tint, np.repeat(grey, 3, 2))
    return Image.fromarray(shown.astype(np.uint8)).resize(PANEL, Image.BILINEAR)


def segment(depth, preset, **parameters):
    return PlaneSegmenter(preset, **parameters).segment(depth, camera=CAMERA)


def values_of(name, default, low, high):
    if name in VALUES:
        return VALUES[name]
    if isinstance(default, bool):
        return (False, True)
    kind = type(default)
    if default == 0:
        return (kind(low), kind(low + (high - low) / 100), kind(low + (high - low) / 10))
    return (max(low, kind(default / FACTOR)), default, min(high, kind(default * FACTOR)))


def draw(depth, reference, name, values, preset):
    results = [segment(depth, preset, **{name: value}) for value in values]
    width = len(values) * (PANEL[0] + GAP) - GAP
    picture = Image.new("RGB", (width, PANEL[1] + CAPTION), "white")
    pen = ImageDraw.Draw(picture)
    for i, (value, result) in enumerate(zip(values, results)):
        left = i * (PANEL[0] + GAP)
        picture.paste(overlay(depth, result.labels, reference), (left, CAPTION))
        shown = "auto" if value == 0 and name in VALUES and not isinstance(value, float) else "%s" % (
            "%g" % value if isinstance(value, float) else value)
        pen.text((left + 2, 1), "%s: %d planes" % (shown, len(result.planes)), fill="black")
    is_same = all(np.array_equal(result.labels, results[0].labels) for result in results)
    return picture, is_same


def text_of(description):
    return description.rstrip(".") + "."


def write_page(depth, out):
    defaults = PlaneSegmenter().parameters
    references = {preset: segment(depth, preset).labels for preset in ("kinect", "paper")}
    lines = [
        "# Tuning", "",
        "The effect of each parameter of the method on one image of the simulated camera. `scripts/make_tuning_page` makes this page from",
        "[PlaneSegmenter.cfg](../cfg/PlaneSegmenter.cfg).", "",
        "Change a parameter while the node runs, and watch `overlay` or rviz:", "", "```sh",
        "rosrun dynamic_reconfigure dynparam set /camera/plane_segmenter min_plane_inliers 1000", "```", "",
        "Start with a preset. Then change one parameter at a time, from the top of this page. Colours follow the planes of the",
        "default; `auto` is a value that is computed from the image's width.", ""]
    os.makedirs(os.path.join(out, "tuning"), exist_ok=True)
    shown_group = None
    for group, name, description, default, low, high in read_parameters():
        if name not in defaults or name in SKIPPED:
            continue
        number = defaults[name]
        if group != shown_group:
            lines += ["## %s" % group.capitalize(), ""]
            shown_group = group
        lines += ["### %s" % name, "", text_of(description), ""]
        if isinstance(number, bool):
            lines += ["Default: %s." % str(number).lower(), ""]
        else:
            lines += ["Default: %g. Bounds: %g to %g." % (default, low, high), ""]
        if group == "outlines":
            continue
        values = values_of(name, number, low, high)
        preset = "kinect"
        picture, is_same = draw(depth, references[preset], name, values, preset)
        if is_same:
            preset = "paper"
            picture, is_same = draw(depth, references[preset], name, values, preset)
        if is_same:
            lines += ["No effect on this image.", ""]
            continue
        if preset == "paper":
            lines += ["With `preset: paper`:", ""]
        picture.quantize(64, dither=Image.NONE).save(os.path.join(out, "tuning", name + ".png"), optimize=True)
        lines += ["![%s](tuning/%s.png)" % (name, name), ""]
    with open(os.path.join(out, "tuning.md"), "w", encoding="utf-8") as page:
        page.write("\n".join(lines))


if __name__ == "__main__":
    run(__doc__, write_page)
