#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The launch files that start a segmenter have the same arguments for frames and queues, and none of them is required.

Usage: arguments_test.py LAUNCH_FOLDER
"""
import pathlib
import sys
import unittest
import xml.etree.ElementTree as ElementTree

SHARED = {"manager", "queue_size", "target_frame"}


def arguments_of(file):
    """Defaults by names, None for a required argument."""
    return {arg.get("name"): arg.get("default") for arg in ElementTree.parse(file).getroot().findall("arg")
            if arg.get("value") is None}


class ArgumentsTest(unittest.TestCase):
    def setUp(self):
        self.arguments = {file.name: arguments_of(file) for file in sorted(FOLDER.glob("*.launch"))}
        self.segmenting = {name: args for name, args in self.arguments.items() if name != "rviz.launch"}

    def test_all_start_files_are_covered(self):
        self.assertEqual({"demo.launch", "multi_camera.launch", "openni2.launch", "plane_segmentation.launch",
                          "playback.launch"}, set(self.segmenting))

    def test_the_same_arguments(self):
        for name, arguments in self.segmenting.items():
            self.assertLessEqual(SHARED, set(arguments), name)
            if name != "multi_camera.launch":  # its cameras have fixed frames
                self.assertLessEqual({"gravity_frame", "fixed_frame"}, set(arguments), name)

    def test_only_the_bag_is_required(self):
        required = {(name, argument) for name, arguments in self.arguments.items()
                    for argument, default in arguments.items() if default is None}
        self.assertEqual({("playback.launch", "bag")}, required)

    def test_the_manager_is_that_of_the_camera(self):
        for name in ("demo.launch", "openni2.launch", "plane_segmentation.launch", "playback.launch"):
            self.assertIn("camera", self.arguments[name]["manager"], name)

    def test_the_camera_driver_takes_a_calibration(self):
        self.assertLessEqual({"calibration_url", "rectify"}, set(self.arguments["openni2.launch"]))
        self.assertIn("info_topic", self.arguments["plane_segmentation.launch"])


if __name__ == "__main__":
    FOLDER = pathlib.Path(sys.argv.pop())
    unittest.main()
