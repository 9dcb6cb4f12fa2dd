#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Whatever runs the segmenter ends without a crash when it is interrupted, also amid traffic."""
import os
import re
import signal
import subprocess
import tempfile
import time
import unittest
import xmlrpc.client

import roslib.packages
import rosgraph
import rospy
import rostest

from line_plane_segmentation.msg import PlaneArray

PLANES = "/camera/plane_segmenter/planes"
CRASHES = ("terminate called", "lock_error", "Abort", "Segmentation fault", "has died", "exit code")


def program(package, name):
    return roslib.packages.find_node(package, name)[0]


def load(nodelet, name, *options):
    """The command that loads a nodelet into the camera's manager and stays beside it."""
    return [program("nodelet", "nodelet"), "load", "line_plane_segmentation/" + nodelet, "manager",
            "__ns:=camera", "__name:=" + name, *options]


class Process:
    """A program and what it writes."""

    def __init__(self, command):
        self.output = tempfile.TemporaryFile()
        # Python's block buffering would withhold roslaunch's messages until it ends.
        environment = dict(os.environ, PYTHONUNBUFFERED="1")
        self.popen = subprocess.Popen(command, env=environment, stdout=self.output, stderr=subprocess.STDOUT)

    def interrupt(self):
        self.popen.send_signal(signal.SIGINT)

    def finish(self):
        """The exit code and the text of a program that was interrupted; one that hangs is killed."""
        try:
            code = self.popen.wait(30)
        except subprocess.TimeoutExpired:
            self.popen.kill()
            code = "none within 30 s"
        return code, self.text()

    def text(self):
        self.output.seek(0)
        return self.output.read().decode(errors="replace")


class CleanExitTest(unittest.TestCase):
    def setUp(self):
        self.processes = []
        self.frames = 0

    def tearDown(self):
        for process in self.processes:
            if process.popen.poll() is None:
                process.interrupt()
                process.finish()

    def start(self, command):
        process = Process(command)
        self.processes.append(process)
        return process

    def wait_until(self, condition, what):
        deadline = time.monotonic() + 60
        while not condition():
            self.assertLess(time.monotonic(), deadline, what)
            time.sleep(0.02)

    def count(self, _):
        self.frames += 1

    def wait_for_planes(self):
        """Subscribes to the planes, so that frames are under way, until some have come."""
        subscriber = rospy.Subscriber(PLANES, PlaneArray, self.count)
        self.addCleanup(subscriber.unregister)
        first = self.frames
        self.wait_until(lambda: self.frames > first + 3, "no planes come")

    def check_end(self, process):
        code, text = process.finish()
        self.assertEqual(0, code, text)
        for crash in CRASHES:
            self.assertNotIn(crash, text)

    def start_camera(self, *options):
        manager = self.start([program("nodelet", "nodelet"), "manager", "__ns:=camera", "__name:=manager"])
        self.start(load("simulated_camera", "simulated_camera", *options))
        self.start(load("plane_segmenter", "plane_segmenter", "depth/image_rect:=depth/image_raw", *options))
        return manager

    def test_manager_amid_traffic(self):
        for delay in (0.0, 0.01, 0.02):
            manager = self.start_camera("--no-bond")
            self.wait_for_planes()
            time.sleep(delay)
            for process in self.processes:
                process.interrupt()
            self.check_end(manager)
            for loader in self.processes[1:]:
                loader.finish()
            self.processes.clear()

    def test_manager_with_bonds(self):
        manager = self.start_camera()
        self.wait_for_planes()
        # Until the bonds have formed nodelet itself aborts, whatever is loaded.
        time.sleep(3.0)
        manager.interrupt()
        self.check_end(manager)

    def test_manager_of_the_demo_at_once(self):
        """Within the second that bonds would take to form, during which nodelet goes on using what it has deleted when it
        has to end. That is not always seen, so this looks whether there are bonds at all."""
        demo = self.start(["roslaunch", "line_plane_segmentation", "demo.launch", "rviz:=false"])
        master = rosgraph.Master("/clean_exit_test")
        self.wait_until(lambda: PLANES in dict(master.getSystemState()[0]), "the demo does not start")
        time.sleep(0.3)
        self.assertNotIn("/camera/camera_nodelet_manager/bond", dict(master.getSystemState()[0]))
        manager = xmlrpc.client.ServerProxy(master.lookupNode("/camera/camera_nodelet_manager"))
        os.kill(manager.getPid("/clean_exit_test")[2], signal.SIGINT)
        # The manager is required, so the launch ends with it; this message says "died" also of a clean end.
        code, text = demo.finish()
        self.assertEqual(0, code, text)
        text, ends = re.subn(r"REQUIRED process \[camera/camera_nodelet_manager-\d+\] has died!\s+"
                             "process has finished cleanly", "", text)
        self.assertEqual(1, ends, text)
        for crash in CRASHES:
            self.assertNotIn(crash, text)

    def test_node_amid_traffic(self):
        self.start_camera("--no-bond")
        node = self.start([program("line_plane_segmentation", "plane_segmenter_node"), "__ns:=camera",
                           "__name:=node", "depth/image_rect:=depth/image_raw"])
        subscriber = rospy.Subscriber("/camera/node/planes", PlaneArray, self.count)
        self.addCleanup(subscriber.unregister)
        self.wait_until(lambda: self.frames > 3, "no planes come")
        node.interrupt()
        self.check_end(node)


if __name__ == "__main__":
    rospy.init_node("clean_exit_test")
    rostest.rosrun("line_plane_segmentation", "clean_exit", CleanExitTest)
