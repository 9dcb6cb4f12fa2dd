# SPDX-License-Identifier: BSD-3-Clause
# A tour of the Python module in cells, as Spyder, VS Code and Jupyter (jupytext) show them. It needs no camera and
# no data: `python3 doc/examples/python/tour.py` runs all of it; with MPLBACKEND=Agg it draws nothing on screen.

# %% A depth image [m]: a floor, a wall and a box on the floor, with the noise of a Kinect
import math
import os
import sys

import matplotlib.pyplot as plt
import numpy as np

from line_plane_segmentation import PlaneSegmenter, PlaneTracker, overlay

WIDTH, HEIGHT = 320, 240
K = np.array([[262.5, 0.0, 159.5], [0.0, 262.5, 119.5], [0.0, 0.0, 1.0]])


def room(shift=0.0, seed=1):
    """A floor 1 m below the camera, a wall 3 m ahead, a box between them, `shift` metres to the right."""
    v, u = np.mgrid[0:HEIGHT, 0:WIDTH]
    x, y = (u - K[0, 2]) / K[0, 0], (v - K[1, 2]) / K[1, 1]
    depth = np.minimum(3.0, 1.0 / np.maximum(y, 1e-6))
    top = 0.6 / np.maximum(y, 1e-6)  # of the box, 60 cm below the camera
    depth = np.where((top > 1.6) & (top < 2.2) & (np.abs(x * top - shift) < 0.4), top, depth)
    front = (np.abs(x * 1.6 - shift) < 0.4) & (y * 1.6 > 0.6) & (y * 1.6 < 1.0)
    depth = np.where(front, 1.6, depth)
    noise = np.random.default_rng(seed).normal(size=depth.shape)
    return (depth + (0.0012 + 0.0019 * (depth - 0.4) ** 2) * noise).astype(np.float32)


# %% Planes and labels
segmenter = PlaneSegmenter()
depth = room()
result = segmenter.segment(depth, K)
for plane in result.planes:
    print(plane.label, plane.normal.round(3), "%.3f m" % plane.d, "%.2f m^2" % plane.area,
          plane.orientation(up=(0.0, -1.0, 0.0)))

# %% The picture, with outlines
figure, (left, right) = plt.subplots(1, 2, figsize=(12, 4.5))
left.imshow(depth, cmap="viridis")
left.set_title("depth [m]")
right.imshow(overlay(depth, result.labels))
for plane in result.planes:
    for ring in plane.outlines + plane.holes:
        pixels = ring @ K.T
        pixels = pixels[:, :2] / pixels[:, 2:]
        right.plot(*np.vstack([pixels, pixels[:1]]).T, color="white", linewidth=1)
right.set_title("%d planes in %.2f ms" % (len(result.planes), segmenter.milliseconds["total"]))
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else os.devnull, format="png")

# %% Invalid pixels: a mask instead of zeros
masked = np.ma.masked_where(depth > 2.8, depth)
print("without the wall:", len(segmenter.segment(masked, K).planes), "planes")

# %% Line segments, the primitives of the method
lines = segmenter.line_segments
print(len(lines), "line segments;", np.count_nonzero(lines["direction"] == 0), "of them along rows")

# %% Ids that stay while the box moves
tracker = PlaneTracker()
for frame in range(4):
    moving = segmenter.segment(room(0.02 * frame, seed=frame), K)
    print("ids", tracker.track(moving, K, seconds=frame / 30.0))

# %% Planes in a frame that stands on the floor: x ahead, y left, z up
pose = np.array([[0.0, 0.0, 1.0, 0.0], [-1.0, 0.0, 0.0, 0.0], [0.0, -1.0, 0.0, 1.0], [0.0, 0.0, 0.0, 1.0]])
for plane in result.planes:
    there = plane.transformed(pose)
    tilt = math.degrees(math.acos(min(1.0, abs(there.normal[2]))))
    print("plane", plane.label, "tilted by %.1f degrees, %.2f m above the floor" % (tilt, there.centroid[2]))

# %%
plt.show()
