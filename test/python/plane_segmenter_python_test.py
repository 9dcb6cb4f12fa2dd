#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The Python module: arrays go in without a copy, planes come out, what is wrong is told, messages stay what they are."""
import os
import subprocess
import sys
import tempfile
import threading
import unittest

import numpy as np
import rostest

from line_plane_segmentation import Plane, PlaneSegmenter, Segmentation

WIDTH, HEIGHT = 320, 240
CAMERA = (262.5, 262.5, 159.5, 119.5)


def corner():
    """Depth [m] of a floor 1 m below the camera before a wall 3 m away."""
    v = np.arange(HEIGHT).reshape(-1, 1)
    below = np.maximum((v - CAMERA[3]) / CAMERA[1], 1e-6)
    return np.broadcast_to(np.minimum(3.0, 1.0 / below), (HEIGHT, WIDTH)).astype(np.float32)


def millimetres(depth):
    return np.round(1000.0 * depth).astype(np.uint16)


class PlaneSegmenterTest(unittest.TestCase):
    def assert_same(self, expected, result):
        np.testing.assert_array_equal(expected.labels, result.labels)
        self.assertEqual(repr(expected.planes), repr(result.planes))
        for one, other in zip(expected.planes, result.planes):
            np.testing.assert_array_equal(one.normal, other.normal)
            self.assertEqual(one.d, other.d)

    def test_finds_floor_and_wall(self):
        result = PlaneSegmenter().segment(millimetres(corner()), CAMERA)
        self.assertIsInstance(result, Segmentation)
        self.assertEqual((HEIGHT, WIDTH), result.labels.shape)
        self.assertEqual(np.uint16, result.labels.dtype)
        self.assertEqual(2, len(result.planes))
        wall, floor = result.planes
        self.assertIsInstance(wall, Plane)
        np.testing.assert_allclose([0, 0, -1], wall.normal, atol=0.01)
        np.testing.assert_allclose([0, -1, 0], floor.normal, atol=0.01)
        self.assertAlmostEqual(3.0, wall.d, delta=0.01)
        self.assertAlmostEqual(1.0, floor.d, delta=0.01)
        self.assertEqual([1, 2], [plane.label for plane in result.planes])
        self.assertEqual(1, result.labels[20, 160])
        self.assertEqual(2, result.labels[230, 160])
        for plane in result.planes:
            self.assertEqual(np.count_nonzero(result.labels == plane.label), plane.inliers)
            self.assertEqual((3,), plane.centroid.shape)
            self.assertAlmostEqual(0.0, float(plane.normal @ plane.centroid + plane.d), delta=1e-3)
            self.assertEqual((4, 4), plane.covariance.shape)
            self.assertTrue(np.all(np.linalg.eigvalsh(plane.covariance) > -1e-12))
            self.assertLess(plane.rms, 0.01)
            self.assertEqual(1, len(plane.outlines))
            self.assertEqual(3, plane.outlines[0].shape[1])
            np.testing.assert_allclose(0.0, plane.outlines[0] @ plane.normal + plane.d, atol=1e-4)
            self.assertEqual([], plane.holes)
        self.assertEqual(WIDTH * HEIGHT, result.valid_pixels)
        self.assertEqual(np.count_nonzero(result.labels), result.assigned_pixels)

    def test_a_hole_has_its_border(self):
        depth = np.full((HEIGHT, WIDTH), 2000, np.uint16)
        depth[100:140, 150:200] = 0
        plane, = PlaneSegmenter().segment(depth, CAMERA).planes
        self.assertEqual(1, len(plane.holes))
        self.assertAlmostEqual(2.0, float(plane.holes[0][0, 2]), delta=0.01)

    def test_every_kind_of_array_gives_the_same(self):
        segmenter = PlaneSegmenter()
        depth = millimetres(corner())
        expected = segmenter.segment(depth, CAMERA)
        tall = np.zeros((2 * HEIGHT, WIDTH + 30), np.uint16)
        tall[::2, 7:WIDTH + 7] = depth
        self.assert_same(expected, segmenter.segment(tall[::2, 7:WIDTH + 7], CAMERA))
        self.assert_same(expected, segmenter.segment(depth.astype(">u2"), CAMERA))
        read_only = depth.copy()
        read_only.setflags(write=False)
        self.assert_same(expected, segmenter.segment(read_only, CAMERA))
        unaligned = np.frombuffer(b"\0" + depth.tobytes(), np.uint8)[1:].view(np.uint16).reshape(depth.shape)
        self.assert_same(expected, segmenter.segment(unaligned, CAMERA))
        # These are the same but for the last digit of a float.
        for result in (segmenter.segment(5 * depth, CAMERA, depth_unit=0.0002),
                       segmenter.segment(5 * depth, CAMERA, 0.0002),
                       segmenter.segment(5 * depth, CAMERA, metres_per_unit=0.0002),
                       segmenter.segment(depth.astype(np.float32) * np.float32(0.001), CAMERA)):
            np.testing.assert_array_equal(expected.labels, result.labels)
            self.assertAlmostEqual(expected.planes[0].d, result.planes[0].d, delta=1e-5)

    def test_the_input_is_read_and_left_as_it_is(self):
        segmenter = PlaneSegmenter()
        depth = millimetres(corner())
        before = depth.copy()
        first = segmenter.segment(depth, CAMERA)
        np.testing.assert_array_equal(before, depth)
        depth[:] = 0
        empty = segmenter.segment(depth, CAMERA)
        self.assertEqual([], empty.planes)
        self.assertEqual(2, len(first.planes), "an earlier result changed")
        self.assertEqual(0, np.count_nonzero(empty.labels))
        self.assertEqual([], segmenter.segment(np.zeros((0, 0), np.uint16), CAMERA).planes)

    def test_parameters(self):
        segmenter = PlaneSegmenter(max_range=2.5, trace_outlines=False)
        plane, = segmenter.segment(millimetres(corner()), CAMERA).planes
        self.assertAlmostEqual(1.0, plane.d, delta=0.01)
        self.assertEqual([], plane.outlines)
        self.assertEqual(2.5, segmenter.parameters["max_range"])
        self.assertIs(False, segmenter.parameters["trace_outlines"])
        self.assertEqual("paper", PlaneSegmenter("paper").parameters["method"])
        segmenter.set_parameters(max_range=10, method="paper")
        self.assertEqual(("paper", 10.0), (segmenter.parameters["method"], segmenter.parameters["max_range"]))
        self.assertEqual(0.3, segmenter.parameters["min_range"])
        with self.assertRaisesRegex(ValueError, "is outside"):
            segmenter.set_parameters(min_range=1.0, max_range=5000)
        self.assertEqual(0.3, segmenter.parameters["min_range"], "a refused call changed something")

    def test_times(self):
        segmenter = PlaneSegmenter()
        segmenter.segment(millimetres(corner()), CAMERA)
        times = segmenter.milliseconds
        self.assertEqual({"lines", "candidates", "extraction", "refinement", "outlines", "total"}, set(times))
        self.assertGreater(times["total"], 0.0)

    def test_what_is_wrong_is_told(self):
        segment = PlaneSegmenter().segment
        depth = millimetres(corner())
        for wrong in (depth.astype(np.int32), depth.astype(np.float64), depth.astype(np.int16)):
            with self.assertRaisesRegex(TypeError, "uint16 or float32, not of " + wrong.dtype.name):
                segment(wrong, CAMERA)
        for wrong in (depth.tolist(), None, "depth"):
            with self.assertRaises(TypeError):
                segment(wrong, CAMERA)
        for wrong in (depth.ravel(), depth[np.newaxis]):
            with self.assertRaisesRegex(ValueError, "two dimensions"):
                segment(wrong, CAMERA)
        for wrong in (depth[:, ::2], depth[::-1], depth.T):
            with self.assertRaisesRegex(ValueError, "ascontiguousarray"):
                segment(wrong, CAMERA)
        for wrong in ((0, 525, 320, 240), (525, 525, float("nan"), 240)):
            with self.assertRaisesRegex(ValueError, "camera must be"):
                segment(depth, wrong)
        with self.assertRaises(TypeError):
            segment(depth, (525, 525, 320))
        with self.assertRaisesRegex(ValueError, "depth_unit must be positive"):
            segment(depth, CAMERA, depth_unit=0)
        with self.assertRaisesRegex(ValueError, "are the same; give one of them"):
            segment(depth, CAMERA, depth_unit=0.001, metres_per_unit=0.001)
        with self.assertRaisesRegex(ValueError, "no preset is named 'lidar'"):
            PlaneSegmenter("lidar")
        with self.assertRaisesRegex(ValueError, "no parameter is named 'speed'"):
            PlaneSegmenter(speed=9)
        with self.assertWarnsRegex(UserWarning, "line_fidelity has no effect on the method adaptive"):
            PlaneSegmenter(line_fidelity=2.0)

    def test_threads_may_share_one(self):
        segmenter = PlaneSegmenter()
        images = [millimetres(corner() + 0.3 * i) for i in range(4)]
        expected = [PlaneSegmenter().segment(image, CAMERA) for image in images]
        problems = []

        def work(i):
            try:
                for _ in range(30):
                    self.assert_same(expected[i], segmenter.segment(images[i], CAMERA))
                    segmenter.set_parameters(max_range=10.0)
                    self.assertEqual(10.0, segmenter.parameters["max_range"])
            except BaseException as problem:
                problems.append(problem)
                raise

        threads = [threading.Thread(target=work, args=(i,)) for i in range(len(images))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join(30)
            self.assertFalse(thread.is_alive(), "threads wait for each other for ever")
        self.assertEqual([], problems)

    def test_messages_need_no_compiled_module(self):
        program = ("import sys; from line_plane_segmentation.msg import Plane, PlaneArray; "
                   "import line_plane_segmentation.cfg.PlaneSegmenterConfig; "
                   "assert 'line_plane_segmentation._plane_segmenter' not in sys.modules; "
                   "import line_plane_segmentation; assert 'PlaneSegmenter' in dir(line_plane_segmentation); "
                   "assert not hasattr(line_plane_segmentation, 'nothing')")
        subprocess.run([sys.executable, "-c", program], check=True)

    def test_everything_is_documented(self):
        for thing in (PlaneSegmenter, Plane, Segmentation):
            for name in [n for n in dir(thing) if not n.startswith("_")]:
                self.assertTrue(getattr(thing, name).__doc__, "%s.%s says nothing" % (thing.__name__, name))

    def test_the_example_plots(self):
        with tempfile.TemporaryDirectory() as folder:
            image, picture = os.path.join(folder, "depth.npy"), os.path.join(folder, "planes.png")
            np.save(image, millimetres(corner()))
            done = subprocess.run([sys.executable, sys.argv[1], "--camera", "262.5,262.5,159.5,119.5", "--save", picture,
                                   image], stdout=subprocess.PIPE, check=True, env=dict(os.environ, MPLBACKEND="Agg"))
            self.assertIn(b"Plane(label=2", done.stdout)
            with open(picture, "rb") as stream:
                self.assertEqual(b"\x89PNG", stream.read(4))
            self.assertGreater(os.path.getsize(picture), 10000)


if __name__ == "__main__":
    rostest.rosrun("line_plane_segmentation", "python", PlaneSegmenterTest)
