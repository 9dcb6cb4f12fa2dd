#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Results of the Python module: they travel between processes, can be tracked, moved and shown; arguments of all kinds
that numpy has are taken."""
import ast
import multiprocessing
import os
import pickle
import subprocess
import sys
import unittest

import numpy as np
import rostest

import line_plane_segmentation
from line_plane_segmentation import Plane, PlaneSegmenter, PlaneTracker, Segmentation, color_of, overlay

WIDTH, HEIGHT = 160, 120
CAMERA = (131.25, 131.25, 79.5, 59.5)
K = np.array([[131.25, 0, 79.5], [0, 131.25, 59.5], [0, 0, 1]])


def corner():
    """Depth [m] of a floor 1 m below the camera before a wall 3 m away, which has a hole."""
    below = np.maximum((np.arange(HEIGHT).reshape(-1, 1) - CAMERA[3]) / CAMERA[1], 1e-6)
    depth = np.broadcast_to(np.minimum(3.0, 1.0 / below), (HEIGHT, WIDTH)).astype(np.float32)
    depth[15:35, 60:90] = 0
    return depth


def segment_in_child(depth):
    return PlaneSegmenter().segment(depth, CAMERA)


class ResultsTest(unittest.TestCase):
    def assert_same(self, expected, result):
        np.testing.assert_array_equal(expected.labels, result.labels)
        self.assertEqual((expected.valid_pixels, expected.assigned_pixels), (result.valid_pixels, result.assigned_pixels))
        self.assertEqual(len(expected.planes), len(result.planes))
        for one, other in zip(expected.planes, result.planes):
            for name in ("label", "d", "inliers", "rms", "area"):
                self.assertEqual(getattr(one, name), getattr(other, name))
            for name in ("normal", "centroid", "covariance", "outlines", "holes"):
                np.testing.assert_equal(getattr(one, name), getattr(other, name))

    def setUp(self):
        self.segmenter = PlaneSegmenter()
        self.result = self.segmenter.segment(corner(), CAMERA)
        self.assertEqual(2, len(self.result.planes))
        self.assertEqual(1, len(self.result.planes[0].holes))

    def test_pickles(self):
        for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
            self.assert_same(self.result, pickle.loads(pickle.dumps(self.result, protocol)))
        plane = pickle.loads(pickle.dumps(self.result.planes[1]))
        self.assertIsInstance(plane, Plane)
        self.assertEqual(self.result.planes[1].d, plane.d)
        with self.assertRaises(ValueError):
            Plane.__new__(Plane).__setstate__((1, 2))

    def test_objects_made_without_init_are_refused(self):
        # In another process, which may crash or wait for a lock that was never made.
        program = """
import copy, inspect, pickle
import numpy
from line_plane_segmentation import _plane_segmenter as lps

result = lps.PlaneSegmenter().segment(numpy.zeros((4, 4), numpy.uint16), (1, 1, 1, 1))
classes = [kind for kind in vars(lps).values() if inspect.isclass(kind)]
assert {kind.__name__ for kind in classes} == {"Plane", "PlaneSegmenter", "PlaneTracker", "Segmentation"}, classes


def refused(what, use):
    try:
        use()
    except TypeError as error:
        if "__init__() was called" in str(error):
            return
        raise
    raise SystemExit("%s works" % what)


def use_of(made, name):
    arguments = {"segment": (None, None), "track": (result, (1, 1, 1, 1), 0.0), "transformed": (numpy.eye(4),),
                 "orientation": ((0, 0, 1),)}.get(name, ())
    value = getattr(made, name)
    if callable(value):
        value(*arguments)


for kind in classes:
    for made in (kind.__new__(kind), type("Derived", (kind,), {}).__new__(type("Derived", (kind,), {}))):
        for name in [name for name in dir(kind) if name[0] != "_"]:
            refused("%s.%s" % (kind.__name__, name), lambda: use_of(made, name))
for kind in (lps.Plane, lps.Segmentation):
    refused("repr", lambda: repr(kind.__new__(kind)))
    refused("pickle", lambda: pickle.dumps(kind.__new__(kind)))
    refused("copy", lambda: copy.copy(kind.__new__(kind)))
unmade = lps.Segmentation.__new__(lps.Segmentation)
refused("track", lambda: lps.PlaneTracker().track(unmade, (1, 1, 1, 1), 0.0))
state = (result.labels, [lps.Plane.__new__(lps.Plane)], 0, 0)
refused("a list of planes", lambda: unmade.__setstate__(state))
try:
    lps.PlaneTracker.reset(5)
except TypeError:
    pass
"""
        result = subprocess.run([sys.executable, "-c", program], timeout=60, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, universal_newlines=True)
        self.assertEqual((0, ""), (result.returncode, result.stdout))

    def test_labels_without_planes_are_refused(self):
        self.result.labels[3, 5] = 3
        with self.assertRaisesRegex(ValueError, "a label has no plane"):
            PlaneTracker().track(self.result, CAMERA, 0.0)
        for wrong in (np.zeros(4, np.uint16), np.zeros((2, 2, 2), np.uint16)):
            with self.assertRaisesRegex(ValueError, "not the state"):
                Segmentation.__new__(Segmentation).__setstate__((wrong, [], 0, 0))
        restored = Segmentation.__new__(Segmentation)
        restored.__setstate__((np.zeros((8, 8), np.uint16)[::2, ::4], [], 0, 0))
        self.assertEqual((4, 2), restored.labels.shape)
        self.assertEqual([], PlaneTracker().track(restored, CAMERA, 0.0))

    def test_other_processes(self):
        for method in ("fork", "spawn", "forkserver"):
            with multiprocessing.get_context(method).Pool(1) as pool:
                self.assert_same(self.result, pool.apply_async(segment_in_child, (corner(),)).get(60))

    def test_the_camera_as_a_matrix(self):
        for camera in (K, K.tolist(), np.float32(K), list(CAMERA), np.array(CAMERA)):
            self.assert_same(self.result, self.segmenter.segment(corner(), camera))
        skewed = K.copy()
        skewed[0, 1] = 1.0
        with self.assertRaisesRegex(ValueError, "without skew"):
            self.segmenter.segment(corner(), skewed)
        for wrong in (K[:2], "525", None, [K], [[1, 2], [3]]):
            with self.assertRaisesRegex(TypeError, "3x3 camera matrix"):
                self.segmenter.segment(corner(), wrong)

    def test_masks_count_as_invalid(self):
        depth = corner()
        mask = np.zeros(depth.shape, bool)
        mask[:, 100:] = True
        expected = self.segmenter.segment(np.where(mask, np.float32(0), depth), CAMERA)
        self.assert_same(expected, self.segmenter.segment(np.ma.array(depth, mask=mask), CAMERA))
        self.assertEqual(0, np.count_nonzero(expected.labels[:, 100:]))
        self.assert_same(self.result, self.segmenter.segment(np.ma.array(depth), CAMERA))

    def test_numbers_of_numpy_as_parameters(self):
        segmenter = PlaneSegmenter(max_range=np.float32(2.5), min_plane_inliers=np.int64(50), trace_outlines=np.bool_(False))
        chosen = segmenter.parameters
        self.assertEqual((2.5, 50, False), (chosen["max_range"], chosen["min_plane_inliers"], chosen["trace_outlines"]))
        self.assert_same(self.result, self.segmenter.segment(corner(), CAMERA, depth_unit=np.float64(1)))

    def test_the_remedy_for_a_wrong_type(self):
        with self.assertRaisesRegex(TypeError, r"float64; depth.astype\(numpy.float32\)"):
            self.segmenter.segment(corner().astype(np.float64), CAMERA)
        with self.assertRaisesRegex(TypeError, r"int32; depth.astype\(numpy.uint16\)"):
            self.segmenter.segment(corner().astype(np.int32), CAMERA)
        with self.assertRaisesRegex(TypeError, "numpy array, not list"):
            self.segmenter.segment(corner().tolist(), CAMERA)

    def test_empty_images_keep_their_shape(self):
        for shape in ((0, 0), (0, 640), (480, 0)):
            result = self.segmenter.segment(np.zeros(shape, np.uint16), CAMERA)
            self.assertEqual(shape, result.labels.shape)
            self.assertEqual([], result.planes)
            self.assert_same(result, pickle.loads(pickle.dumps(result)))

    def test_planes_in_another_frame(self):
        pose = np.array([[0, 0, 1, 0.5], [-1, 0, 0, 0], [0, -1, 0, 1.0], [0, 0, 0, 1.0]])
        wall, floor = (plane.transformed(pose) for plane in self.result.planes)
        np.testing.assert_allclose([0, 0, 1], floor.normal, atol=0.01)
        self.assertAlmostEqual(0.0, floor.d, delta=0.01)
        np.testing.assert_allclose([-1, 0, 0], wall.normal, atol=0.01)
        self.assertAlmostEqual(3.5, wall.centroid[0], delta=0.01)
        for plane in (wall, floor):
            for ring in plane.outlines + plane.holes:
                np.testing.assert_allclose(0.0, ring @ plane.normal + plane.d, atol=1e-4)
        self.assertEqual("horizontal_up", floor.orientation(up=(0, 0, 2)))
        self.assertEqual("horizontal_down", floor.orientation(up=[0, 0, -1]))
        self.assertEqual("vertical", wall.orientation(up=np.array([0, 0, 1])))
        self.assertEqual("slanted", wall.orientation(up=(1, 0, 1)))
        for wrong in (np.eye(3), 2 * np.eye(4), np.diag([1, 1, -1, 1]), np.full((4, 4), np.nan)):
            with self.assertRaisesRegex(ValueError, "pose must be"):
                floor.transformed(wrong)
        for up, tolerance in (((0, 0, 0), 0.1), ((0, 1), 0.1), ((0, 0, 1), 1.0), ((0, 0, 1), np.nan)):
            with self.assertRaises(ValueError):
                floor.orientation(up, tolerance)

    def test_ids_stay(self):
        tracker = PlaneTracker()
        self.assertEqual([1, 2], tracker.track(self.result, CAMERA, 0.0))
        # The wall is gone, as if something large stood before it: its id comes back with it.
        near = self.segmenter.segment(np.where(corner() < 2.9, corner(), np.float32(0)), CAMERA)
        self.assertEqual([2], tracker.track(near, K, 0.1, motion=np.eye(4)))
        self.assertEqual([1, 2], tracker.track(pickle.loads(pickle.dumps(self.result)), CAMERA, 0.2))
        self.assertEqual([1], tracker.track(near, CAMERA, 0.1), "seconds went back, ids count from 1 again")
        tracker.reset()
        self.assertEqual([1, 2], tracker.track(self.result, CAMERA, 0.0))
        with self.assertRaisesRegex(ValueError, "motion must be"):
            tracker.track(self.result, CAMERA, 1.0, motion=np.zeros((4, 4)))
        with self.assertRaisesRegex(ValueError, "track_angle is out of bounds"):
            PlaneTracker(track_angle=100.0)

    def test_line_segments(self):
        lines = self.segmenter.line_segments
        self.assertGreater(len(lines), 10)
        self.assertEqual({0, 1}, set(lines["direction"]))
        self.assertTrue(np.all(lines["first"] < lines["last"]))
        rows = lines[(lines["direction"] == 0) & (lines["scanline"] < 10)]
        # Along a row, distances are measured in the plane of the row and the camera.
        np.testing.assert_allclose(3.0 * np.hypot(1.0, (rows["scanline"] - CAMERA[3]) / CAMERA[1]), rows["r"], atol=0.02)
        self.assertEqual((2, 2), lines["covariance"].shape[1:])
        self.assertTrue(np.all(np.linalg.eigvalsh(lines["covariance"]) > -1e-12))
        np.testing.assert_array_equal(lines, pickle.loads(pickle.dumps(lines)))

    def test_candidates(self):
        candidates = self.segmenter.candidates
        self.assertGreater(len(candidates), 10)
        np.testing.assert_allclose(1.0, np.linalg.norm(candidates["normal"], axis=1))
        self.assertTrue(np.all((candidates["curvature"] >= 0.0) & (candidates["curvature"] <= 1.0 / 3.0)))
        # The wall's depth is exact, the floor's is rounded.
        self.assertTrue(np.all(candidates["curvature"][candidates["v"] > 110] > 0.0))
        ray = np.stack([(candidates["u"] - CAMERA[2]) / CAMERA[0], (candidates["v"] - CAMERA[3]) / CAMERA[1],
                        np.ones(len(candidates))], axis=1)
        depth = -candidates["d"] / np.sum(candidates["normal"] * ray, axis=1)
        on_wall = candidates["v"] < 100
        self.assertTrue(np.any(on_wall))
        np.testing.assert_allclose(3.0, depth[on_wall], atol=0.02)
        np.testing.assert_array_equal(candidates, pickle.loads(pickle.dumps(candidates)))

    def test_curvature_comes_from_noise(self):
        exact = self.segmenter.candidates["curvature"]
        depth = corner()
        depth *= 1.0 + 1e-3 * np.random.default_rng(1).standard_normal(depth.shape, dtype=np.float32)
        self.segmenter.segment(depth, CAMERA)
        noisy = self.segmenter.candidates["curvature"]
        self.assertTrue(np.all(noisy > 0.0))
        self.assertLess(np.median(exact), 1e-3 * np.median(noisy))

    def test_the_overlay(self):
        depth = corner()
        picture = overlay(depth, self.result.labels)
        self.assertEqual(((HEIGHT, WIDTH, 3), np.uint8), (picture.shape, picture.dtype))
        hole, wall, floor = picture[25, 75], picture[5, 5], picture[115, 80]
        self.assertEqual(1, len(set(hole)), "invalid depth is grey")
        self.assertTrue(np.argmax(wall) == np.argmax(color_of(1)) and np.argmax(floor) == np.argmax(color_of(2)))
        np.testing.assert_array_equal(picture, overlay(np.ma.masked_equal(depth, 0), self.result.labels))
        with self.assertRaisesRegex(ValueError, "same two dimensions"):
            overlay(depth[1:], self.result.labels)

    def test_help_has_signatures_and_parameters(self):
        text = PlaneSegmenter.__doc__
        for name in self.segmenter.parameters:
            self.assertRegex(text, r"(?m)^%s: \[" % name)
        self.assertTrue(PlaneSegmenter.segment.__doc__.startswith("segment(depth, camera, depth_unit=None)"))
        for method in (PlaneTracker.track, Plane.transformed, Plane.orientation, PlaneSegmenter.set_parameters):
            self.assertTrue(method.__doc__.startswith(method.__name__ + "("), method.__doc__)

    def test_stubs_and_module_have_the_same_names(self):
        folder = os.path.dirname(line_plane_segmentation.overlay.__code__.co_filename)
        with open(os.path.join(folder, "_plane_segmenter.pyi"), encoding="utf-8") as stream:
            classes = [node for node in ast.parse(stream.read()).body if isinstance(node, ast.ClassDef)]
        self.assertEqual({"Plane", "PlaneSegmenter", "PlaneTracker", "Segmentation"}, {node.name for node in classes})
        for node in classes:
            stubs = {method.name for method in node.body if not method.name.startswith("_")}
            names = {name for name in dir(getattr(line_plane_segmentation, node.name)) if not name.startswith("_")}
            self.assertEqual(names, stubs, node.name)

    def test_the_version(self):
        self.assertRegex(line_plane_segmentation.__version__, r"^\d+\.\d+\.\d+$")
        self.assertTrue(line_plane_segmentation.__version__.startswith(line_plane_segmentation.__abi__ + "."))
        self.assertEqual(Segmentation, type(self.result))


if __name__ == "__main__":
    rostest.rosrun("line_plane_segmentation", "python_results", ResultsTest)
