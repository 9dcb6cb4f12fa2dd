# SPDX-License-Identifier: BSD-3-Clause
"""The process that publishes a topic, and its resources."""
import re
import xmlrpc.client

import rosgraph


def publisher_of(topic):
    """The XML-RPC server of its node."""
    master = rosgraph.Master("/test")
    nodes = dict(master.getSystemState()[0])[topic]
    return xmlrpc.client.ServerProxy(master.lookupNode(nodes[0]))


def process_that_publishes(topic):
    """Its process id."""
    return publisher_of(topic).getPid("/test")[2]


def kilobytes(process, name):
    """A value of /proc/PID/status: VmRSS is the resident memory, VmData the allocated memory."""
    with open("/proc/%d/status" % process) as status:
        return int(re.search(name + r":\s*(\d+) kB", status.read()).group(1))
