#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""After a crash of the nodelet manager the segmenter is loaded again, or the launch ends: nothing stays up dead."""
import os
import signal
import subprocess
import threading
import time
import unittest
import xmlrpc.client

import rosgraph
import rospy
import rostest

from line_plane_segmentation.msg import PlaneArray

PATIENCE_S = 40


def process_of(node):
    """The process id of a node."""
    master = rosgraph.Master("/recovery_launch_test")
    return xmlrpc.client.ServerProxy(master.lookupNode(node)).getPid("/recovery_launch_test")[2]


class RecoveryTest(unittest.TestCase):
    def wait_for_planes(self, topic):
        """Subscribes until three frames have come."""
        frames = threading.Semaphore(0)
        subscriber = rospy.Subscriber(topic, PlaneArray, lambda _: frames.release())
        deadline = time.monotonic() + PATIENCE_S
        for _ in range(3):
            self.assertTrue(frames.acquire(timeout=max(0.0, deadline - time.monotonic())), "no planes on " + topic)
        subscriber.unregister()

    def test_the_segmenter_comes_back_with_its_manager(self):
        self.wait_for_planes("/xtion/plane_segmenter/planes")
        crashed = process_of("/driver_manager")
        os.kill(crashed, signal.SIGKILL)
        self.wait_for_planes("/xtion/plane_segmenter/planes")
        self.assertNotEqual(crashed, process_of("/driver_manager"))

    def test_a_launch_that_started_the_manager_ends(self):
        demo = subprocess.Popen(["roslaunch", "line_plane_segmentation", "demo.launch", "rviz:=false"],
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            self.wait_for_planes("/camera/plane_segmenter/planes")
            os.kill(process_of("/camera/camera_nodelet_manager"), signal.SIGKILL)
            demo.wait(PATIENCE_S)
        finally:
            if demo.poll() is None:
                demo.send_signal(signal.SIGINT)
                demo.wait(PATIENCE_S)


if __name__ == "__main__":
    rospy.init_node("recovery_launch_test")
    rostest.rosrun("line_plane_segmentation", "recovery_launch", RecoveryTest)
