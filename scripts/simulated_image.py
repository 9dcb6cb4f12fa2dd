# SPDX-License-Identifier: BSD-3-Clause
"""The depth image of which the pages of doc/ show pictures, and the command line of the scripts that make them."""
import argparse

import numpy as np

CAMERA = (525.0, 525.0, 319.5, 239.5)  # of the simulated camera at 640 x 480


def grab(topic):
    import rospy
    from sensor_msgs.msg import Image
    rospy.init_node("pictures", anonymous=True)
    message = rospy.wait_for_message(topic, Image, timeout=30.0)
    return np.frombuffer(message.data, np.uint16).reshape(message.height, message.width).copy()


def run(description, write):
    """Reads the command line and calls write(depth, folder); depth is 16UC1, (480, 640) [mm]."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--topic", help="topic of the depth image, 640 x 480 and 16UC1")
    parser.add_argument("--depth", help="a .npy file in its place")
    parser.add_argument("--out", required=True, help="folder to write to")
    arguments = parser.parse_args()
    write(np.load(arguments.depth) if arguments.depth else grab(arguments.topic), arguments.out)
