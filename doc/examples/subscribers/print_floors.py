#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the horizontal planes that a segmenter publishes. Needs its parameter gravity_frame."""
import rospy
from line_plane_segmentation.msg import Plane, PlaneArray


def print_floors(message):
    for plane in message.planes:
        if plane.orientation == Plane.HORIZONTAL_UP:
            print("floor or table %d: %.2f m from the camera, %.2f m2" % (plane.id, plane.coefficients.coef[3], plane.area))


rospy.init_node("print_floors")
rospy.Subscriber("/camera/plane_segmenter/planes", PlaneArray, print_floors, queue_size=1)
rospy.spin()
