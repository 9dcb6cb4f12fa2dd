#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""upright_frame beside a camera without tf, and beside one that tf knows."""
import subprocess
import unittest

import rospy
import rostest
import tf2_ros
from sensor_msgs.msg import CameraInfo


def publish_info(namespace, frame):
    """A latched camera_info; the publisher has to be kept."""
    publisher = rospy.Publisher("/" + namespace + "/camera_info", CameraInfo, queue_size=1, latch=True)
    info = CameraInfo()
    info.header.frame_id = frame
    publisher.publish(info)
    return publisher


class UprightFrameTest(unittest.TestCase):
    def setUp(self):
        self.buffer = tf2_ros.Buffer()
        self.listener = tf2_ros.TransformListener(self.buffer)

    def lookup(self, target, source):
        """Translation and rotation as lists."""
        transform = self.buffer.lookup_transform(target, source, rospy.Time(0), rospy.Duration(20)).transform
        return ([getattr(transform.translation, axis) for axis in "xyz"],
                [getattr(transform.rotation, axis) for axis in "xyzw"])

    def assert_close(self, expected, actual):
        for one, other in zip(expected, actual):
            self.assertAlmostEqual(one, other, places=5, msg="%s is not %s" % (actual, expected))

    def test_without_tf_the_frame_goes_along_with_the_camera(self):
        publisher = publish_info("bare", "/bare_optical")
        translation, rotation = self.lookup("bare_upright", "bare_optical")
        self.assert_close([0, 0, 0], translation)
        # z ahead, x right, y down  ->  x ahead, y left, z up
        self.assert_close([-0.5, 0.5, -0.5, 0.5], rotation)
        # Straight ahead.
        translation, _ = self.lookup("bare_upright", "bare_view")
        self.assert_close([1, 0, 0], translation)
        publisher.unregister()

    def test_with_tf_the_frame_is_level_and_stays_in_the_world(self):
        publisher = publish_info("mounted", "mounted_optical")
        translation, rotation = self.lookup("world", "mounted_upright")
        self.assert_close([3, 2, 1], translation)
        # x looks along y, as the camera does; z is up, as the camera's is not
        self.assert_close([0, 0, 0.5 ** 0.5, 0.5 ** 0.5], rotation)
        # On the optical axis, which points 30 degrees down.
        translation, _ = self.lookup("world", "mounted_view")
        self.assert_close([3, 2 + 0.75 ** 0.5, 0.5], translation)

        # Another one, as of rviz.launch, ends by itself.
        subprocess.run(["rosrun", "line_plane_segmentation", "upright_frame", "elsewhere", "mounted", "__ns:=mounted",
                        "__name:=second"], check=True, timeout=20)
        translation, _ = self.lookup("world", "mounted_upright")
        self.assert_close([3, 2, 1], translation)
        publisher.unregister()

    def test_a_camera_without_a_frame_ends_it_with_a_warning(self):
        publisher = publish_info("nameless", "")
        result = subprocess.run(["rosrun", "line_plane_segmentation", "upright_frame", "world", "nameless",
                                 "__ns:=nameless"], check=True, timeout=20, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, universal_newlines=True)
        self.assertIn("the camera's messages have no frame_id", result.stdout)
        self.assertNotIn("canTransform", result.stdout)
        publisher.unregister()


if __name__ == "__main__":
    rospy.init_node("upright_frame_test")
    rostest.rosrun("line_plane_segmentation", "upright_frame", UprightFrameTest)
