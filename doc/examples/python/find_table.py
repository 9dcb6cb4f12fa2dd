#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The largest horizontal surface of a depth image, such as a table, in a frame whose z axis is up. With type
annotations: `mypy --strict find_table.py` checks it.

Usage: find_table.py DEPTH.npy FX,FY,CX,CY [HEIGHT [PITCH]]

HEIGHT [m] and PITCH [degrees, down is positive] of the camera above the floor, default 1.2 and 30.
"""
import math
import sys
from typing import Optional, Sequence

import numpy as np
from numpy.typing import NDArray

from line_plane_segmentation import Plane, PlaneSegmenter, Segmentation


def camera_pose(height: float, pitch: float) -> NDArray[np.float64]:
    """Pose (4, 4) of the optical frame (z ahead, y down) in a frame on the floor (x ahead, z up)."""
    s, c = math.sin(pitch), math.cos(pitch)
    return np.array([[0.0, -s, c, 0.0], [-1.0, 0.0, 0.0, 0.0], [0.0, -c, -s, height], [0.0, 0.0, 0.0, 1.0]])


def largest_table(result: Segmentation, pose: NDArray[np.float64]) -> Optional[Plane]:
    """The largest horizontal plane that is seen from above and at least 30 cm above the floor."""
    for plane in result.planes:
        there = plane.transformed(pose)
        if there.orientation(up=(0.0, 0.0, 1.0)) == "horizontal_up" and there.centroid[2] > 0.3:
            return there
    return None


def main(arguments: Sequence[str]) -> int:
    if len(arguments) < 2:
        print(__doc__)
        return 1
    depth = np.load(arguments[0])
    camera = [float(number) for number in arguments[1].split(",")]
    height = float(arguments[2]) if len(arguments) > 2 else 1.2
    pitch = math.radians(float(arguments[3]) if len(arguments) > 3 else 30.0)

    result = PlaneSegmenter(min_plane_area=np.float32(0.05)).segment(depth, camera)
    table = largest_table(result, camera_pose(height, pitch))
    if table is None:
        print("no table")
        return 1
    print("a table of %.2f m^2, %.3f m above the floor" % (table.area, table.centroid[2]))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
