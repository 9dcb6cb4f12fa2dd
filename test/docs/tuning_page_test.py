#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/tuning_page.py has a picture of each parameter that changes an image, and doc/tuning.md is up to date."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np

from line_plane_segmentation import PlaneSegmenter

ROOT = pathlib.Path(__file__).resolve().parents[2]


def room():
    """A wall, a floor and a box before them, 16UC1 in millimetres, with a Kinect's noise."""
    v, u = np.mgrid[0:480, 0:640]
    x, y = (u - 319.5) / 525.0, (v - 239.5) / 525.0
    depth = np.minimum(3.0 + 0.0 * x, 1.0 / np.maximum(y, 1e-6))
    depth = np.where((abs(x + 0.2) < 0.12) & (abs(y) < 0.12), 1.5 + 0.3 * x, depth)
    depth += np.random.RandomState(1).normal(size=depth.shape) * (0.0012 + 0.0019 * (depth - 0.4) ** 2)
    return (1000.0 * depth).round().astype(np.uint16)


def facts(page):
    """What a page says of each parameter, without its pictures."""
    return [line for line in page.splitlines() if re.match(r"##|\[[^\]]*\] |Default: ", line)]


class TuningPage(unittest.TestCase):
    def test_is_made_of_all_parameters(self):
        with tempfile.TemporaryDirectory() as folder:
            np.save(os.path.join(folder, "room.npy"), room())
            subprocess.run([sys.executable, str(ROOT / "scripts" / "tuning_page.py"), "--depth",
                            os.path.join(folder, "room.npy"), "--out", folder], check=True)
            page = pathlib.Path(folder, "tuning.md").read_text(encoding="utf-8")
            pictures = {path.stem for path in pathlib.Path(folder, "tuning").glob("*.png")}
        headings = set(re.findall(r"^### (\w+)$", page, re.MULTILINE))
        self.assertEqual(set(PlaneSegmenter().parameters) - {"method"}, headings)
        self.assertEqual(set(re.findall(r"\(tuning/(\w+)\.png\)", page)), pictures)
        self.assertLessEqual({"patch_noise_factor", "min_plane_inliers", "max_range", "line_fidelity"}, pictures)

        committed = (ROOT / "doc" / "tuning.md").read_text(encoding="utf-8")
        self.assertEqual(facts(page), facts(committed), "run scripts/make_tuning_page")
        for name in re.findall(r"\(tuning/(\w+)\.png\)", committed):
            self.assertTrue((ROOT / "doc" / "tuning" / (name + ".png")).exists(), name)


if __name__ == "__main__":
    unittest.main()
