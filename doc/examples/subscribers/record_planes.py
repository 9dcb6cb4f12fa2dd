#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the planes of a number of images as a CSV table of measurements for a SLAM back end."""
import argparse
import csv
import queue

import rospy
from line_plane_segmentation.msg import PlaneArray

COLUMNS = ["stamp", "id", "nx", "ny", "nz", "d"] + ["c%d%d" % (row, column) for row in range(4) for column in range(4)]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("file", help="the table to write")
    parser.add_argument("--images", type=int, default=100, help="number of images (default: %(default)s)")
    parser.add_argument("--topic", default="/camera/plane_segmenter/planes", help="default: %(default)s")
    arguments = parser.parse_args(rospy.myargv()[1:])

    rospy.init_node("record_planes", anonymous=True)
    messages = queue.Queue()
    subscriber = rospy.Subscriber(arguments.topic, PlaneArray, messages.put)
    rows = 0
    with open(arguments.file, "w", newline="") as table:
        writer = csv.writer(table)
        writer.writerow(COLUMNS)
        for _ in range(arguments.images):
            try:
                message = messages.get(timeout=30.0)
            except queue.Empty:
                raise SystemExit("no message on %s for 30 s" % arguments.topic)
            for plane in message.planes:
                writer.writerow(["%.9f" % message.header.stamp.to_sec(), plane.id] +
                                ["%.9g" % value for value in plane.coefficients.coef + plane.covariance])
                rows += 1
    subscriber.unregister()
    print("%d measurements of %d images" % (rows, arguments.images))


if __name__ == "__main__":
    main()
