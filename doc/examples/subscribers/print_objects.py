#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the objects of one image that has any. Needs the segmenter's parameter gravity_frame."""
import rospy
from line_plane_segmentation.msg import SupportedObjectArray


def distance(point):
    return (point.x ** 2 + point.y ** 2 + point.z ** 2) ** 0.5


rospy.init_node("print_objects", anonymous=True)
message = SupportedObjectArray()
while not message.objects:
    message = rospy.wait_for_message("/camera/plane_segmenter/objects", SupportedObjectArray, timeout=30.0)
for thing in message.objects:
    size = thing.box_size
    print("object of %.2f x %.2f x %.2f m on plane %d, %.2f m away, %d pixels" %
          (size.x, size.y, size.z, thing.support_id, distance(thing.centroid), thing.pixels))
