#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Planes of the simulated camera's room come on the topic `planes`."""
import math
import threading
import unittest

import rospy
import rostest

from line_plane_segmentation.msg import PlaneArray

FRAMES = 30


class PlanesArriveTest(unittest.TestCase):
    def test_planes_arrive(self):
        arrays = []
        enough = threading.Event()

        def collect(message):
            arrays.append(message)
            if len(arrays) >= FRAMES:
                enough.set()

        subscriber = rospy.Subscriber("planes", PlaneArray, collect, queue_size=FRAMES)
        self.assertTrue(enough.wait(60), "%d frames of %d came" % (len(arrays), FRAMES))
        subscriber.unregister()

        arrays = arrays[:FRAMES]
        stamps = [array.header.stamp for array in arrays]
        self.assertEqual(sorted(set(stamps)), stamps)
        for array in arrays:
            self.assertGreaterEqual(len(array.planes), 2, "a room shows at least two planes")
            self.assertGreater(array.assigned_pixels, 0.5 * array.valid_pixels)
            for plane in array.planes:
                a, b, c, d = plane.coefficients.coef
                self.assertAlmostEqual(1.0, math.sqrt(a * a + b * b + c * c), places=6)
                self.assertGreaterEqual(d, 0.0)


if __name__ == "__main__":
    rospy.init_node("planes_arrive_test")
    rostest.rosrun("line_plane_segmentation", "planes_arrive", PlanesArriveTest)
