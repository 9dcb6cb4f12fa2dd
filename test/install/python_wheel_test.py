#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The installed wheel: it is the one that is imported, is what its metadata say, and type-checks and runs the examples.

Usage: python_wheel_test.py SITE SOURCE
"""
import importlib.metadata
import os
import subprocess
import sys
import unittest
import xml.etree.ElementTree as ElementTree

import numpy as np

import line_plane_segmentation
from line_plane_segmentation import _plane_segmenter

SITE, SOURCE = sys.argv.pop(1), sys.argv.pop(1)


class WheelTest(unittest.TestCase):
    def test_the_wheel_is_complete(self):
        self.assertTrue(_plane_segmenter.__file__.startswith(SITE), _plane_segmenter.__file__)
        files = os.listdir(os.path.dirname(_plane_segmenter.__file__))
        for name in ("__init__.py", "__init__.pyi", "_overlay.py", "_overlay.pyi", "_plane_segmenter.pyi", "py.typed"):
            self.assertIn(name, files)

    def test_needs_no_library_of_the_build(self):
        needed = subprocess.run(["ldd", _plane_segmenter.__file__], stdout=subprocess.PIPE, check=True).stdout.decode()
        self.assertNotIn("not found", needed)
        self.assertNotIn("line_plane_segmentation_core", needed)
        self.assertNotIn("libros", needed)

    def test_versions(self):
        package = ElementTree.parse(os.path.join(SOURCE, "package.xml")).getroot()
        version = package.find("version").text
        self.assertEqual(version, line_plane_segmentation.__version__)
        self.assertEqual(version, importlib.metadata.version("line_plane_segmentation"))
        self.assertEqual(".".join(version.split(".")[:2]), line_plane_segmentation.__abi__)

    def test_segments(self):
        depth = np.full((120, 160), 2000, np.uint16)
        result = line_plane_segmentation.PlaneSegmenter().segment(depth, (131.25, 131.25, 79.5, 59.5))
        self.assertEqual(1, len(result.planes))
        self.assertAlmostEqual(2.0, result.planes[0].d, delta=0.01)

    def test_the_tour(self):
        picture = os.path.join(SITE, "tour.png")
        done = subprocess.run([sys.executable, os.path.join(SOURCE, "doc/examples/python/tour.py"), picture],
                              stdout=subprocess.PIPE, check=True)
        self.assertIn(b"horizontal_up", done.stdout)
        self.assertIn(b"ids [1, 2", done.stdout)
        self.assertGreater(os.path.getsize(picture), 10000)

    def test_the_typed_example(self):
        example = os.path.join(SOURCE, "doc/examples/python/find_table.py")
        # A table 40 cm below a camera that looks down steeply, at 1.2 m.
        v, u = np.mgrid[0:240, 0:320]
        pitch, y = np.radians(60.0), (v - 119.5) / 262.5
        down = np.maximum(np.sin(pitch) + y * np.cos(pitch), 1e-6)
        depth = (0.4 / down).astype(np.float32)
        depth[np.abs(u - 160) > 120] = (1.2 / down).astype(np.float32)[np.abs(u - 160) > 120]
        image = os.path.join(SITE, "table.npy")
        np.save(image, depth)
        done = subprocess.run([sys.executable, example, image, "262.5,262.5,159.5,119.5", "1.2", "60"],
                              stdout=subprocess.PIPE, check=True)
        self.assertRegex(done.stdout.decode(), r"a table of \d\.\d+ m\^2, 0\.80\d m above the floor")

    def test_the_stubs(self):
        example = os.path.join(SOURCE, "doc/examples/python/find_table.py")
        command = [sys.executable, "-m", "mypy", "--cache-dir", os.path.join(SITE, ".mypy"), "--strict"]
        environment = dict(os.environ, MYPYPATH="")
        checked = subprocess.run(command + [example], stdout=subprocess.PIPE, env=environment)
        self.assertEqual(0, checked.returncode, checked.stdout.decode())
        wrong = os.path.join(SITE, "wrong.py")
        with open(wrong, "w", encoding="utf-8") as stream:
            stream.write("from line_plane_segmentation import PlaneSegmenter\nPlaneSegmenter().segment('depth', 1).area\n")
        checked = subprocess.run(command + [wrong], stdout=subprocess.PIPE, env=environment)
        self.assertIn(b'has no attribute "area"', checked.stdout)


if __name__ == "__main__":
    unittest.main()
