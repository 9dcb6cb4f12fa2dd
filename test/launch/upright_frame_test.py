#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""upright_frame beside a camera without tf, and beside one that tf knows."""
import threading
import unittest

import rospy
import rostest
import tf2_ros
from sensor_msgs.msg import CameraInfo
from tf2_msgs.msg import TFMessage


def camera(namespace, frame):
    """A latched camera_info."""
    publisher = rospy.Publisher("/" + namespace + "/camera_info", CameraInfo, queue_size=1, latch=True)
    info = CameraInfo()
    info.header.frame_id = frame
    publisher.publish(info)
    return publisher


class UprightFrameTest(unittest.TestCase):
    def test_lays_a_frame_only_where_tf_has_none(self):
        laid = {}
        done = threading.Event()

        def note(message):
            if "upright_frame" in message._connection_header["callerid"]:
                for transform in message.transforms:
                    laid[transform.child_frame_id] = transform
                done.set()

        rospy.Subscriber("/tf_static", TFMessage, note)
        buffer = tf2_ros.Buffer()
        tf2_ros.TransformListener(buffer)
        cameras = [camera("mounted", "mounted_optical"), camera("bare", "/bare_optical")]

        self.assertTrue(done.wait(20), "no frame was laid")
        rospy.sleep(2)
        self.assertEqual(["world"], list(laid))
        self.assertEqual("bare_optical", laid["world"].header.frame_id)

        rotation = buffer.lookup_transform("world", "bare_optical", rospy.Time(0), rospy.Duration(5)).transform.rotation
        # z forward, x right, y down  ->  x forward, y left, z up
        self.assertEqual((-0.5, 0.5, -0.5, 0.5), (rotation.x, rotation.y, rotation.z, rotation.w))
        self.assertEqual(2, len(cameras))


if __name__ == "__main__":
    rospy.init_node("upright_frame_test")
    rostest.rosrun("line_plane_segmentation", "upright_frame", UprightFrameTest)
