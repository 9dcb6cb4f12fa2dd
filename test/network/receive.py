#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Receives messages of any type: receive.py TOPIC COUNT. Writes the size of each [bytes] on a line when it comes."""
import sys
import threading

import rospy


def main():
    topic, count = sys.argv[1], int(sys.argv[2])
    rospy.init_node("receive", anonymous=True, disable_signals=True)
    sizes = []
    enough = threading.Event()

    def collect(message):
        if len(sizes) < count:
            sizes.append(len(message._buff))
            print(sizes[-1], flush=True)
        if len(sizes) == count:
            enough.set()

    rospy.Subscriber(topic, rospy.AnyMsg, collect, queue_size=count)
    sys.exit(0 if enough.wait(40) else "receive.py: %d of %d came" % (len(sizes), count))


if __name__ == "__main__":
    main()
