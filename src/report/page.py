# SPDX-License-Identifier: BSD-3-Clause
"""The HTML page of segment_depth."""

import base64
import io
import json
import math
import os
import pathlib
import statistics

import jinja2
import PIL.Image

MOST_PICTURES = 200
MOST_COLUMNS = 300
STAGE_COLORS = ("#4477aa", "#66ccee", "#228833", "#ccbb44", "#ee6677", "#aa3377", "#bbbbbb")


def path_of(encoded):
    """Paths come as lists of bytes, since they need not be UTF-8 as JSON has to be."""
    return os.fsdecode(bytes(encoded))


def jpeg_of(overlay):
    """An overlay image as base64 text of a JPEG, and its size [px]."""
    picture = PIL.Image.open(overlay).convert("RGB")
    encoded = io.BytesIO()
    picture.save(encoded, "JPEG", quality=85)
    return {"base64": base64.b64encode(encoded.getvalue()).decode(), "width": picture.width, "height": picture.height}


def read_frame(files, stages):
    with open(path_of(files["planes"]), encoding="utf-8", errors="surrogateescape") as stream:
        document = json.load(stream)
    times = document["milliseconds"]
    return {"name": document["frame"], "planes": document["planes"], "stages": [times[s] for s in stages],
            "total": times["total"], "overlay": path_of(files["overlay"])}


def changed_parameters(data):
    changed = ["%s = %s" % (name, json.dumps(value)) for name, value in sorted(data["parameters"].items())
               if value != data["defaults"][name]]
    return ", ".join(changed) or "the defaults"


def round_up(value):
    """The least of 1, 2, 5, 10, 20, 50, ... that is not below the value."""
    if value <= 0:
        return 1.0
    power = 10.0 ** math.floor(math.log10(value))
    return next(step * power for step in (1, 2, 5, 10) if step * power >= value)


def columns_of(frames):
    """The columns of the plot: each frame, or of many frames the means of neighbours."""
    count = min(len(frames), MOST_COLUMNS)
    columns = []
    for c in range(count):
        first, end = c * len(frames) // count, (c + 1) * len(frames) // count
        group = frames[first:end]
        columns.append({"first": first,
                        "stages": [statistics.fmean(times) for times in zip(*(f["stages"] for f in group))],
                        "planes": statistics.fmean(len(f["planes"]) for f in group)})
    return columns


def with_pictures(frames):
    """The frames that are shown with their overlay: all, or of many the first of each of 200 equal groups."""
    count = min(len(frames), MOST_PICTURES)
    return {i * len(frames) // count for i in range(count)}


def html(data):
    frames = [read_frame(files, data["stages"]) for files in data["frames"]]
    columns = columns_of(frames)
    shown = with_pictures(frames)
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(str(pathlib.Path(__file__).parent / "templates")),
                                     autoescape=True, trim_blocks=True, lstrip_blocks=True)
    pieces = environment.get_template("page.html.j2").generate(
        frames=frames, columns=columns, shown=shown, stages=list(zip(data["stages"], STAGE_COLORS)),
        colors=[tuple(color) for color in data["colors"]], parameters=changed_parameters(data), picture=jpeg_of,
        most_time=round_up(max(sum(c["stages"]) for c in columns)),
        most_planes=round_up(max(c["planes"] for c in columns)),
        planes_per_frame=statistics.fmean(len(f["planes"]) for f in frames),
        median=statistics.median(f["total"] for f in frames), slowest=max(f["total"] for f in frames))
    return "".join(pieces).encode("utf-8", "replace")
