#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""openni2.launch with and without its driver package, as far as that goes without a camera."""
import contextlib
import os
import subprocess
import tempfile
import unittest
import unittest.mock

import roslaunch.config as roslaunch_config
import roslib.packages
import rostest


@contextlib.contextmanager
def driver(found):
    """Has `rospack find openni2_camera`, and no other rospack, succeed or fail."""
    with tempfile.TemporaryDirectory() as folder:
        rospack = os.path.join(folder, "rospack")
        with open(rospack, "w") as script:
            script.write("#!/bin/sh\n" + ("echo /somewhere" if found else "exit 1") + "\n")
        os.chmod(rospack, 0o755)
        with unittest.mock.patch.dict(os.environ, PATH=folder + ":" + os.environ["PATH"]):
            yield


def roslaunch(*options, driver_found):
    """Loads openni2.launch, with roslaunch's own options and arguments of the launch file."""
    listing = [option for option in options if ":=" not in option]
    arguments = [option for option in options if ":=" in option]
    command = ["roslaunch", *listing, "line_plane_segmentation", "openni2.launch", "rviz:=false", *arguments]
    with driver(driver_found):
        return subprocess.run(command, timeout=60, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              universal_newlines=True)


def nodes_of(argument):
    """The nodes that openni2.launch starts with this argument, by their names."""
    path = roslib.packages.find_resource("line_plane_segmentation", "openni2.launch")[0]
    with driver(True):
        config = roslaunch_config.load_config_default([(path, ["rviz:=false", argument])], None, verbose=False)
    return {node.name: node for node in config.nodes}


class OpenNi2LaunchTest(unittest.TestCase):
    def test_without_the_driver_one_line_says_what_to_install(self):
        result = roslaunch(driver_found=False)
        advice = [line for line in result.stdout.splitlines() if "ros-noetic-openni2-camera" in line]
        self.assertEqual(1, len(advice), result.stdout)
        self.assertIn("scripts/build_openni2_camera DIR", advice[0])
        self.assertEqual(1, result.returncode)
        self.assertNotIn("process[", result.stdout, "something was started all the same")

    def test_with_the_driver_it_is_driver_segmenter_and_one_manager(self):
        result = roslaunch("--nodes", driver_found=True)
        self.assertEqual(0, result.returncode, result.stdout)
        nodes = {line for line in result.stdout.splitlines() if line.startswith("/")}
        self.assertEqual({"/camera/camera_nodelet_manager", "/camera/driver", "/camera/plane_segmenter",
                          "/camera/upright_frame"}, nodes)

    def test_the_manager_is_required_or_started_again(self):
        for respawn in (False, True):
            nodes = nodes_of("respawn:=%s" % str(respawn).lower())
            manager = nodes.pop("camera_nodelet_manager")
            self.assertEqual((respawn, not respawn), (manager.respawn, manager.required))
            for name in ("driver", "plane_segmenter"):
                self.assertEqual(respawn, nodes[name].respawn, name)
                self.assertEqual(respawn, "--no-bond" not in nodes[name].args, "without a bond the loss is not noticed")


if __name__ == "__main__":
    rostest.rosrun("line_plane_segmentation", "openni2_launch", OpenNi2LaunchTest)
