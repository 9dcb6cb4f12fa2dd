# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the pages with pictures share."""
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]


def room():
    """A wall, a floor and a box before them, 16UC1 in millimetres, with a Kinect's noise."""
    v, u = np.mgrid[0:480, 0:640]
    x, y = (u - 319.5) / 525.0, (v - 239.5) / 525.0
    depth = np.minimum(3.0 + 0.0 * x, 1.0 / np.maximum(y, 1e-6))
    depth = np.where((abs(x + 0.2) < 0.12) & (abs(y) < 0.12), 1.5 + 0.3 * x, depth)
    depth += np.random.RandomState(1).normal(size=depth.shape) * (0.0012 + 0.0019 * (depth - 0.4) ** 2)
    return (1000.0 * depth).round().astype(np.uint16)


class Made(tempfile.TemporaryDirectory):
    """A folder with what a script of scripts/ makes of the room."""

    def __init__(self, script):
        super().__init__()
        depth = os.path.join(self.name, "room.npy")
        np.save(depth, room())
        subprocess.run([sys.executable, str(ROOT / "scripts" / script), "--depth", depth, "--out", self.name],
                       check=True)
