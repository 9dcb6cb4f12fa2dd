#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the commands of the tutorials, in their order, as a reader would type them.

A block of sh whose command is roslaunch stays in the background until the page's end. Every other command has to succeed and
to print something. A block of text after it is an example of a line that it prints, but for the numbers.
"""
import os
import re
import signal
import subprocess
import sys
import tempfile
import unittest

import rospkg
import rospy
import rostest

from line_plane_segmentation.msg import PlaneArray

FOLDER = os.path.join(rospkg.RosPack().get_path("line_plane_segmentation"), "doc", "tutorials")
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
NUMBER = re.compile(r"-?\d+(\.\d+)?(e-?\d+)?")


def without_numbers(text):
    return {NUMBER.sub("N", line.strip()) for line in text.splitlines() if line.strip()}


class TutorialsTest(unittest.TestCase):
    def setUp(self):
        self.background = []
        self.folder = tempfile.TemporaryDirectory()

    def tearDown(self):
        for process in self.background:
            os.killpg(process.pid, signal.SIGINT)
            process.wait(30)
        self.folder.cleanup()

    def launch(self, command):
        log = open(os.path.join(self.folder.name, "launch.log"), "w")
        self.background.append(subprocess.Popen(["bash", "-c", "exec " + command], cwd=self.folder.name, stdout=log,
                                                stderr=subprocess.STDOUT, start_new_session=True))
        rospy.wait_for_message("/camera/plane_segmenter/planes", PlaneArray, timeout=60)

    def execute(self, command):
        result = subprocess.run(["bash", "-c", command], cwd=self.folder.name, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, timeout=60, universal_newlines=True)
        self.assertEqual(0, result.returncode, command + "\n" + result.stdout + result.stderr)
        self.assertTrue(result.stdout.strip() or "dynparam set" in command, command + " prints nothing")
        return result.stdout

    def run_page(self, name):
        with open(os.path.join(FOLDER, name), encoding="utf-8") as page:
            blocks = BLOCK.findall(page.read())
        output, commands = "", 0
        for language, content in blocks:
            if language == "text":
                self.assertTrue(without_numbers(content) <= without_numbers(output), content + "\nis not in\n" + output)
            if language != "sh":
                continue
            output = ""
            for command in content.replace("\\\n", " ").splitlines():
                commands += 1
                if command.startswith("roslaunch"):
                    self.launch(command)
                else:
                    output += self.execute(command)
        return commands

    def test_obstacles(self):
        self.assertEqual(5, self.run_page("obstacles.md"))

    def test_objects(self):
        self.assertEqual(4, self.run_page("objects.md"))

    def test_slam(self):
        self.assertEqual(4, self.run_page("slam.md"))

    def test_every_page_is_run(self):
        tests = {name[len("test_"):] + ".md" for name in dir(self) if name.startswith("test_")}
        self.assertLessEqual(set(os.listdir(FOLDER)), tests)


if __name__ == "__main__":
    rospy.init_node("tutorials_test")
    rostest.rosrun("line_plane_segmentation", "tutorials", TutorialsTest, sys.argv)
