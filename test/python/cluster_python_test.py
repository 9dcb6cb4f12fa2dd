#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""doc/examples/cluster/segment_folder.py with two worker processes finds what one process finds, to the last digit."""
import csv
import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np
import rostest
from PIL import Image

from line_plane_segmentation import PlaneSegmenter

CAMERA = (131.25, 131.25, 79.5, 59.5)
EXAMPLE = sys.argv[1]


def corner(i):
    """A floor before a wall that is farther away from image to image, with noise [mm]."""
    below = np.maximum((np.arange(120).reshape(-1, 1) - CAMERA[3]) / CAMERA[1], 1e-6)
    depth = 1000.0 * np.broadcast_to(np.minimum(2.0 + 0.1 * i, 1.0 / below), (120, 160))
    return np.round(depth + np.random.default_rng(i).normal(size=depth.shape, scale=4.0)).astype(np.uint16)


class ClusterTest(unittest.TestCase):
    def test_two_workers_find_what_one_process_finds(self):
        with tempfile.TemporaryDirectory() as folder:
            expected = []
            for i in range(12):
                name = "%04d.png" % i
                depth = corner(i)
                Image.fromarray(depth.astype(np.int32), "I").save(os.path.join(folder, name))
                for plane in PlaneSegmenter().segment(depth, CAMERA).planes:
                    expected.append([name, plane.label, *plane.normal, plane.d, plane.inliers, plane.rms, plane.area])
            self.assertGreaterEqual(len(expected), 18)

            table = os.path.join(folder, "planes.csv")
            done = subprocess.run([sys.executable, EXAMPLE, "--camera", "131.25,131.25,79.5,59.5", "--workers", "2",
                                   folder, table], stdout=subprocess.PIPE, check=True, timeout=100)
            self.assertIn(b"in 12 images, by 2 workers", done.stdout)
            with open(table, newline="", encoding="utf-8") as stream:
                rows = list(csv.reader(stream))[1:]
        self.assertEqual([[row[0]] + [float(x) for x in row[1:]] for row in expected],
                         [[row[0]] + [float(x) for x in row[1:]] for row in rows])


if __name__ == "__main__":
    rostest.rosrun("line_plane_segmentation", "python_cluster", ClusterTest)
