#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the planes of a running segmenter once a second, then saves the picture of the last ones; called by scripts/demo."""

import argparse
import os
import sys
import threading
import time

import rospy
from PIL import Image as Picture
from sensor_msgs.msg import Image
from visualization_msgs.msg import MarkerArray

from line_plane_segmentation.msg import Plane, PlaneArray

FIRST_MESSAGE_SECONDS = 30.0
KEPT_STAMPS = 60
ORIENTATIONS = {getattr(Plane, name): name.lower().replace("_", " ")
                for name in ("UNKNOWN", "HORIZONTAL_UP", "HORIZONTAL_DOWN", "VERTICAL", "SLANTED")}


class Frames:
    """Collects the planes, the overlay and the markers of one segmenter by their stamps."""

    def __init__(self, segmenter):
        self.lock = threading.Condition()
        self.by_stamp = {}
        self.complete = None  # the newest three of one stamp, by topic
        self.count = 0
        for topic, kind in (("planes", PlaneArray), ("overlay", Image), ("markers", MarkerArray)):
            rospy.Subscriber(segmenter + "/" + topic, kind, self.store, callback_args=topic, queue_size=10)

    def store(self, message, topic):
        header = message.markers[0].header if topic == "markers" else message.header
        with self.lock:
            self.count += topic == "planes"
            messages = self.by_stamp.setdefault(header.stamp, {})
            messages[topic] = message
            if len(messages) == 3:
                self.complete = messages
                self.by_stamp = {}
                self.lock.notify_all()
            elif len(self.by_stamp) > KEPT_STAMPS:
                del self.by_stamp[min(self.by_stamp)]

    def wait(self):
        with self.lock:
            if not self.lock.wait_for(lambda: self.complete, FIRST_MESSAGE_SECONDS):
                sys.exit("No planes came within %.0f s." % FIRST_MESSAGE_SECONDS)

    def newest(self):
        with self.lock:
            return self.complete


def colors_of(markers):
    """The colours (r, g, b) of the planes' ids in the overlay, from those of the arrows, which are 60 % white."""
    return {marker.id: tuple(round(255 * (channel - 0.6) / 0.4)
                             for channel in (marker.color.r, marker.color.g, marker.color.b))
            for marker in markers.markers if marker.ns == "normals"}


def color_text(color):
    """`#rrggbb`, on a terminal with a patch of the colour before it."""
    patch = "\x1b[48;2;%d;%d;%dm  \x1b[0m " % color if sys.stdout.isatty() else ""
    return patch + "#%02x%02x%02x" % color


def print_table(planes, markers):
    print("\n%d planes in an image of %d x %d pixels, found in %.1f ms" %
          (len(planes.planes), planes.image_width, planes.image_height, planes.processing_time))
    print("     id  %scolour   orientation       normal (x, y, z)          distance     area    noise    pixels" %
          ("   " if sys.stdout.isatty() else ""))
    colors = colors_of(markers)
    for plane in planes.planes:
        a, b, c, d = plane.coefficients.coef
        print("  %5d  %s  %-15s   %+.3f  %+.3f  %+.3f   %6.3f m  %5.2f m2  %4.1f mm  %8d" %
              (plane.id, color_text(colors[plane.id]), ORIENTATIONS[plane.orientation], a, b, c, d, plane.area,
               1000.0 * plane.rms, plane.inliers))
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
    frames = Frames(arguments.segmenter)
    frames.wait()

    start = time.monotonic()
    first = frames.count
    while True:
        last = frames.newest()
        print_table(last["planes"], last["markers"])
        time.sleep(1.0)
        if time.monotonic() >= start + arguments.seconds or rospy.is_shutdown():
            break
    rate = (frames.count - first) / (time.monotonic() - start)

    save(last["overlay"], arguments.overlay)
    print("\n%.0f images a second. The planes of the last table, in their colours: %s" % (rate, arguments.overlay))


if __name__ == "__main__":
    main()
