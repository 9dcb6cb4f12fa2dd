#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Row 34: subscribers that connect and never read neither delay others nor use up memory."""
import io
import socket
import time
import unittest

import rosgraph.network
import rospy
import rostest
import roslib.message
from sensor_msgs.msg import CameraInfo

from line_plane_segmentation.msg import PlaneArray
from node_process import kilobytes, process_that_publishes, publisher_of

OUTPUTS = ("planes", "labels", "cloud", "overlay", "markers", "scanlines")
SECONDS = 5


def connect(topic):
    """A subscriber that connects by TCPROS and then never reads."""
    _, _, (_, host, port) = publisher_of(topic).requestTopic(rospy.get_name(), topic, [["TCPROS"]])
    type_name = dict(rospy.get_published_topics())[topic]
    connection = socket.create_connection((host, port))
    header = {"topic": topic, "callerid": "/hung_subscriber", "type": type_name,
              "md5sum": roslib.message.get_message_class(type_name)._md5sum}
    rosgraph.network.write_ros_handshake_header(connection, header)
    answer = rosgraph.network.read_ros_handshake_header(connection, io.BytesIO(), 4096)
    assert answer["type"] == type_name, answer
    return connection


class HungSubscriberTest(unittest.TestCase):
    def test_nobody_waits_for_it(self):
        answers, images = [], []
        rospy.Subscriber("plane_segmenter/planes", PlaneArray, lambda message: answers.append(message.header.stamp))
        rospy.Subscriber("depth/camera_info", CameraInfo, lambda message: images.append(message.header.stamp))
        deadline = time.monotonic() + 30
        while not answers and time.monotonic() < deadline:
            time.sleep(0.05)
        self.assertTrue(answers, "no planes come")

        hung = [connect("/plane_segmenter/" + output) for output in OUTPUTS]
        time.sleep(2)
        process = process_that_publishes("/plane_segmenter/planes")
        before = kilobytes(process, "VmRSS")
        del answers[:], images[:]
        time.sleep(SECONDS)
        answered, came = set(answers), set(images)
        for connection in hung:
            connection.close()

        self.assertGreater(len(came), 5 * SECONDS)
        self.assertGreater(len(answered & came), 0.9 * len(came) - 2, "%d of %d" % (len(answered), len(came)))
        # The clouds published in this time need more than 100 MB.
        self.assertLess(kilobytes(process, "VmRSS"), before + 30e3)


if __name__ == "__main__":
    rospy.init_node("hung_subscriber_test")
    rostest.rosrun("line_plane_segmentation", "hung_subscriber", HungSubscriberTest)
