#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Segments a depth image and plots the planes with matplotlib: in the image, and their outlines in space.

    plot_planes.py --camera 525,525,319.5,239.5 --depth-unit 0.0002 depth.png
"""
import argparse

import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from line_plane_segmentation import PlaneSegmenter


def read_depth(path):
    """A 16-bit PNG, or an array that numpy saved."""
    if path.endswith(".npy"):
        return np.load(path)
    # matplotlib makes a PNG's numbers 0 to 1.
    return np.round(plt.imread(path) * 65535).astype(np.uint16)


def plot_labels(axes, depth, result, colors):
    axes.imshow(depth, cmap="gray")
    axes.imshow(np.ma.masked_equal(result.labels, 0), cmap=colors, vmin=1, vmax=colors.N, alpha=0.6, interpolation="nearest")
    for plane in result.planes:
        v, u = (int(np.median(side)) for side in np.nonzero(result.labels == plane.label))
        axes.text(u, v, str(plane.label), color="white", weight="bold", ha="center", va="center")
    axes.set_title("%d planes" % len(result.planes))
    axes.set_axis_off()


def plot_outlines(axes, result, colors):
    """In the optical frame, turned so that up is up: x right, z ahead, y down."""
    for plane in result.planes:
        rings = [ring[:, [0, 2, 1]] * (1, 1, -1) for ring in plane.outlines]
        axes.add_collection3d(Poly3DCollection(rings, facecolor=colors(plane.label - 1), alpha=0.7, edgecolor="black"))
    corners = np.concatenate([ring for plane in result.planes for ring in plane.outlines] or [np.ones((1, 3))])
    axes.set(xlim=(corners[:, 0].min(), corners[:, 0].max()), ylim=(0, corners[:, 2].max()),
             zlim=(-corners[:, 1].max(), -corners[:, 1].min()), xlabel="x [m]", ylabel="z [m]", zlabel="-y [m]")
    axes.view_init(elev=20, azim=-75)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("image", help="16-bit PNG, or .npy of uint16 or float32")
    parser.add_argument("--camera", required=True, help="FX,FY,CX,CY in pixels")
    parser.add_argument("--depth-unit", type=float, help="[m]; default: 0.001 for 16-bit, 1 for float")
    parser.add_argument("--save", metavar="FILE", help="save the plot and show no window")
    arguments = parser.parse_args()

    depth = read_depth(arguments.image)
    camera = [float(number) for number in arguments.camera.split(",")]
    result = PlaneSegmenter().segment(depth, camera, arguments.depth_unit)
    for plane in result.planes:
        print(plane)

    colors = plt.get_cmap("tab20")
    figure = plt.figure(figsize=(12, 5))
    plot_labels(figure.add_subplot(1, 2, 1), depth, result, colors)
    plot_outlines(figure.add_subplot(1, 2, 2, projection="3d"), result, colors)
    figure.tight_layout()
    if arguments.save:
        figure.savefig(arguments.save)
    else:
        plt.show()


if __name__ == "__main__":
    main()
