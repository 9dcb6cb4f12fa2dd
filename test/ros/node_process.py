# SPDX-License-Identifier: BSD-3-Clause
"""The process behind a topic, and what it uses."""
import re
import xmlrpc.client

import rosgraph


def publisher_of(topic):
    """The server by which ROS speaks to its node."""
    master = rosgraph.Master("/test")
    nodes = dict(master.getSystemState()[0])[topic]
    return xmlrpc.client.ServerProxy(master.lookupNode(nodes[0]))


def process_that_publishes(topic):
    """Its process id."""
    return publisher_of(topic).getPid("/test")[2]


def kilobytes(process, name):
    """A figure of /proc/PID/status: VmRSS is the memory in use, VmData what was ever asked for and not given back."""
    with open("/proc/%d/status" % process) as status:
        return int(re.search(name + r":\s*(\d+) kB", status.read()).group(1))
