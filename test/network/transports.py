#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How the messages of a topic leave their publisher: transports.py TOPIC. Writes one transport for each subscriber."""
import sys
import xmlrpc.client

import rosgraph


def main():
    topic = sys.argv[1]
    master = rosgraph.Master("/transports")
    publishers = [node for name, nodes in master.getSystemState()[0] if name == topic for node in nodes]
    for publisher in publishers:
        connections = xmlrpc.client.ServerProxy(master.lookupNode(publisher)).getBusInfo("/transports")[2]
        for _, _, direction, transport, name, *_ in connections:
            if name == topic and direction == "o":
                print(transport)


if __name__ == "__main__":
    main()
