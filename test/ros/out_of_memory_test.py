#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Row 28: running out of memory affects only the frame in process."""
import array
import resource
import threading
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from sensor_msgs.msg import CameraInfo, Image

from line_plane_segmentation.msg import PlaneArray
from node_process import kilobytes, process_that_publishes

# An image of 4096x4096 exists twice on reception, as bytes and as a message: 67 MB. Segmenting it needs more than
# three times as much.
LARGE = 4096
ENOUGH_TO_RECEIVE = 110 << 20
SMALL = 320


def frame(size, seconds):
    """A square image of a wall at 1.5 m, and its camera_info."""
    image = Image(height=size, width=size, encoding="16UC1", step=2 * size,
                  data=array.array("H", [1500] * (size * size)).tobytes())
    info = CameraInfo(height=size, width=size)
    info.K = [0.8 * size, 0, size / 2, 0, 0.8 * size, size / 2, 0, 0, 1]
    info.P = [0.8 * size, 0, size / 2, 0, 0, 0.8 * size, size / 2, 0, 0, 0, 1, 0]
    image.header.stamp = info.header.stamp = rospy.Time(seconds)
    image.header.frame_id = info.header.frame_id = "camera"
    return image, info


class OutOfMemoryTest(unittest.TestCase):
    def setUp(self):
        self.changed = threading.Condition()
        self.answers = {}
        self.status = None
        self.images = rospy.Publisher("depth/image_rect", Image, queue_size=1)
        self.infos = rospy.Publisher("depth/camera_info", CameraInfo, queue_size=1)
        rospy.Subscriber("plane_segmenter/planes", PlaneArray, self.take_answer)
        rospy.Subscriber("/diagnostics", DiagnosticArray, self.take_status)
        self.wait_for(lambda: self.images.get_num_connections() and self.infos.get_num_connections())

    def take_answer(self, answer):
        with self.changed:
            self.answers[answer.header.stamp.secs] = answer
            self.changed.notify_all()

    def take_status(self, message):
        with self.changed:
            for status in message.status:
                if status.name == "plane_segmenter: plane segmentation":
                    self.status = status
            self.changed.notify_all()

    def wait_for(self, condition):
        with self.changed:
            return self.changed.wait_for(condition, 20)

    def publish(self, size, seconds):
        image, info = frame(size, seconds)
        self.images.publish(image)
        self.infos.publish(info)

    def expect_answer(self, seconds):
        self.assertTrue(self.wait_for(lambda: seconds in self.answers), "frame %d is not answered" % seconds)
        self.assertEqual(1, len(self.answers[seconds].planes))

    def failed(self):
        values = {value.key: value.value for value in self.status.values} if self.status else {}
        return values.get("frames failed")

    def test_it_goes_on(self):
        self.publish(SMALL, 1)
        self.expect_answer(1)
        process = process_that_publishes("/plane_segmenter/planes")
        unlimited = resource.prlimit(process, resource.RLIMIT_DATA)
        limit = 1024 * kilobytes(process, "VmData") + ENOUGH_TO_RECEIVE
        resource.prlimit(process, resource.RLIMIT_DATA, (limit, unlimited[1]))

        self.publish(LARGE, 2)
        self.assertTrue(self.wait_for(lambda: self.failed() == "1"), self.status)
        self.assertIn("std::bad_alloc", self.status.message)
        self.assertNotIn(2, self.answers)
        self.publish(SMALL, 3)
        self.expect_answer(3)

        resource.prlimit(process, resource.RLIMIT_DATA, unlimited)
        self.publish(LARGE, 4)
        self.expect_answer(4)


if __name__ == "__main__":
    rospy.init_node("out_of_memory_test")
    rostest.rosrun("line_plane_segmentation", "out_of_memory", OutOfMemoryTest)
