#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""benchmark_messages measures, and says what it cannot do. Of the times only what holds on any machine is looked at."""
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

import roslib.packages
import rostest


def run(*arguments, **environment):
    program = roslib.packages.find_node("line_plane_segmentation", "benchmark_messages")[0]
    return subprocess.run([program, *arguments], env={**os.environ, **environment}, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, universal_newlines=True, timeout=50, check=False)


class BenchmarkMessagesTest(unittest.TestCase):
    def refused(self, reason, *arguments, **environment):
        result = run(*arguments, **environment)
        self.assertEqual((1, ""), (result.returncode, result.stdout))
        self.assertRegex(result.stderr, "^benchmark_messages: .*" + re.escape(reason) + ".*\n$")

    def test_measures_rooms(self):
        with tempfile.TemporaryDirectory() as folder:
            result = run("--rooms", "2", "--repetitions", "3", "--out", folder)
            self.assertEqual((0, ""), (result.returncode, result.stderr))
            self.assertEqual(result.stdout, (pathlib.Path(folder) / "messages.md").read_text())
        rows = re.findall(r"^\| room (\d) \| 640x480 \| (.*) \|$", result.stdout, re.MULTILINE)
        self.assertEqual(["1", "2"], [room for room, _ in rows])
        for _, cells in rows:
            planes, segmenter, answered, ratio, all_answered, all_ratio = map(float, cells.split(" | "))
            self.assertGreater(planes, 3)
            self.assertLess(0.0, segmenter)
            self.assertLess(segmenter, answered)
            self.assertLess(1.0, ratio)
            self.assertLess(segmenter, all_answered)
            self.assertLess(1.0, all_ratio)

    def test_refuses(self):
        self.refused("--rooms must be", "--rooms", "0")
        self.refused("--repetitions must be", "--repetitions", "-1")
        self.refused("/nowhere/frames.csv", "--frames", "/nowhere")
        self.refused("no ROS master", ROS_MASTER_URI="http://127.0.0.1:9")


if __name__ == "__main__":
    rostest.rosrun("line_plane_segmentation", "benchmark_messages", BenchmarkMessagesTest)
