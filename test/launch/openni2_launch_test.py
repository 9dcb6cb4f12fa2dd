#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""openni2.launch with and without its driver package, as far as that goes without a camera."""
import os
import subprocess
import tempfile
import unittest

import rostest


def roslaunch(*options, driver_found):
    """Loads openni2.launch where `rospack find openni2_camera` does or does not succeed."""
    with tempfile.TemporaryDirectory() as folder:
        rospack = os.path.join(folder, "rospack")
        with open(rospack, "w") as script:
            script.write("#!/bin/sh\n" + ("echo /somewhere" if driver_found else "exit 1") + "\n")
        os.chmod(rospack, 0o755)
        environment = dict(os.environ, PATH=folder + ":" + os.environ["PATH"])
        command = ["roslaunch", *options, "line_plane_segmentation", "openni2.launch", "rviz:=false"]
        return subprocess.run(command, env=environment, timeout=60, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, universal_newlines=True)


class OpenNi2LaunchTest(unittest.TestCase):
    def test_without_the_driver_one_line_says_what_to_install(self):
        result = roslaunch(driver_found=False)
        advice = [line for line in result.stdout.splitlines() if "ros-noetic-openni2-camera" in line]
        self.assertEqual(1, len(advice), result.stdout)
        self.assertEqual(1, result.returncode)
        self.assertNotIn("process[", result.stdout, "something was started all the same")

    def test_with_the_driver_it_is_driver_segmenter_and_one_manager(self):
        result = roslaunch("--nodes", driver_found=True)
        self.assertEqual(0, result.returncode, result.stdout)
        nodes = {line for line in result.stdout.splitlines() if line.startswith("/")}
        self.assertEqual({"/camera/camera_nodelet_manager", "/camera/driver", "/camera/plane_segmenter"}, nodes)


if __name__ == "__main__":
    rostest.rosrun("line_plane_segmentation", "openni2_launch", OpenNi2LaunchTest)
