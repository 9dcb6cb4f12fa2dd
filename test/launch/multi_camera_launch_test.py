#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""multi_camera.launch: two cameras in one nodelet manager have nothing to do with each other."""
import subprocess
import threading
import unittest

import dynamic_reconfigure.client
import rosgraph
import roslaunch.config as roslaunch_config
import roslib.packages
import rospy
import rostest

from line_plane_segmentation.msg import PlaneArray

MANAGER = "/camera_nodelet_manager"
PATIENCE_S = 30


class Camera:
    """The planes of one camera."""

    def __init__(self, name):
        self.segmenter = "/" + name + "/plane_segmenter"
        self.arrays = []
        self.news = threading.Condition()
        rospy.Subscriber(self.segmenter + "/planes", PlaneArray, self.collect, queue_size=10)

    def collect(self, message):
        with self.news:
            self.arrays.append(message)
            self.news.notify_all()

    def next(self, count):
        """The next messages; fewer if they do not come in time."""
        with self.news:
            first = len(self.arrays)
            self.news.wait_for(lambda: len(self.arrays) >= first + count, PATIENCE_S)
            return self.arrays[first:first + count]


class MultiCameraLaunchTest(unittest.TestCase):
    def test_two_cameras_are_independent(self):
        one, other = Camera("camera_1"), Camera("camera_2")

        # Both at once, each in its own frame, each of its own room.
        for name, camera in (("camera_1", one), ("camera_2", other)):
            arrays = camera.next(10)
            self.assertEqual(10, len(arrays), name)
            for array in arrays:
                self.assertEqual(name + "_depth_optical_frame", array.header.frame_id)
                self.assertGreaterEqual(len(array.planes), 2, name)
        self.assertNotEqual([plane.area for plane in one.arrays[0].planes],
                            [plane.area for plane in other.arrays[0].planes])
        for topic, nodes in rosgraph.Master(rospy.get_name()).getSystemState()[0]:
            if topic.endswith(("/planes", "/depth/image_raw")):
                self.assertEqual([MANAGER], nodes, topic)

        # What is set for one does not count for the other.
        client = dynamic_reconfigure.client.Client(one.segmenter, timeout=PATIENCE_S)
        self.assertEqual(0, client.update_configuration({"method": "paper"})["method"], "a method has a name")
        client.update_configuration({"method": "adaptive", "min_plane_area": 100.0})
        one.next(2)  # may have been on their way
        self.assertEqual([0] * 5, [len(array.planes) for array in one.next(5)])
        self.assertGreaterEqual(min(len(array.planes) for array in other.next(5)), 2)

        # One goes, the other goes on.
        subprocess.run(["rosrun", "nodelet", "nodelet", "unload", one.segmenter, MANAGER], check=True,
                       timeout=PATIENCE_S)
        rospy.rostime.wallsleep(0.5)
        gone = len(one.arrays)
        self.assertEqual(10, len(other.next(10)))
        self.assertEqual(gone, len(one.arrays))

    def test_the_windows_are_side_by_side(self):
        path = roslib.packages.find_resource("line_plane_segmentation", "multi_camera.launch")[0]
        config = roslaunch_config.load_config_default([path], None, verbose=False)
        windows = [list(map(int, node.args.split("--window ")[1].split(",")))
                   for node in config.nodes if node.type == "rviz_view"]
        self.assertEqual(2, len(windows))
        (left, top, width, height), (other_left, other_top, other_width, other_height) = sorted(windows)
        self.assertLessEqual(left + width, other_left)
        self.assertEqual((top, width, height), (other_top, other_width, other_height))
        self.assertLessEqual(other_left + other_width, 1920, "the width of most screens")


if __name__ == "__main__":
    rospy.init_node("multi_camera_launch_test")
    rostest.rosrun("line_plane_segmentation", "multi_camera_launch", MultiCameraLaunchTest)
