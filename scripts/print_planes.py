#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the planes of a running segmenter once a second, then saves its overlay picture; called by scripts/demo."""

import argparse
import os
import sys
import threading
import time

import rospy
from PIL import Image as Picture
from sensor_msgs.msg import Image

from line_plane_segmentation.msg import PlaneArray

FIRST_MESSAGE_SECONDS = 30.0


class Latest:
    """The newest message of a topic, and how many have come."""

    def __init__(self, topic, kind):
        self.topic = topic
        self.message = None
        self.count = 0
        self.arrived = threading.Event()
        rospy.Subscriber(topic, kind, self.store, queue_size=1)

    def store(self, message):
        self.message = message
        self.count += 1
        self.arrived.set()

    def wait(self, seconds):
        if not self.arrived.wait(seconds):
            sys.exit("No message came on %s within %.0f s." % (self.topic, seconds))


def print_table(planes):
    print("\n%d planes in an image of %d x %d pixels, found in %.1f ms" %
          (len(planes.planes), planes.image_width, planes.image_height, planes.processing_time))
    print("  label   normal (x, y, z)          distance     area    noise    pixels")
    for plane in planes.planes:
        a, b, c, d = plane.coefficients.coef
        print("  %5d   %+.3f  %+.3f  %+.3f   %6.3f m  %5.2f m2  %4.1f mm  %8d" %
              (plane.label, a, b, c, d, plane.area, 1000.0 * plane.rms, plane.inliers))
    sys.stdout.flush()


def save(overlay, path):
    size = (overlay.width, overlay.height)
    os.makedirs(os.path.dirname(os.path.abspath(path)), exist_ok=True)
    Picture.frombytes("RGB", size, overlay.data, "raw", "RGB", overlay.step).save(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("segmenter", help="name of the segmenter's node, for example /camera/plane_segmenter")
    parser.add_argument("--seconds", type=float, default=6.0, help="how long to go on after the first planes")
    parser.add_argument("--overlay", required=True, metavar="FILE.png", help="where to save the overlay picture")
    arguments = parser.parse_args()

    rospy.init_node("print_planes", anonymous=True)
    planes = Latest(arguments.segmenter + "/planes", PlaneArray)
    overlay = Latest(arguments.segmenter + "/overlay", Image)
    planes.wait(FIRST_MESSAGE_SECONDS)

    start = time.monotonic()
    first = planes.count
    while time.monotonic() < start + arguments.seconds and not rospy.is_shutdown():
        print_table(planes.message)
        time.sleep(1.0)
    rate = (planes.count - first) / (time.monotonic() - start)

    overlay.wait(FIRST_MESSAGE_SECONDS)
    save(overlay.message, arguments.overlay)
    print("\n%.0f images a second. The last one with its planes in colour: %s" % (rate, arguments.overlay))


if __name__ == "__main__":
    main()
