#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Two computers, played by two network namespaces: master, camera and segmenter on one, a subscriber on the other. The
planes cross the wire between them, the image does not."""
import os
import pathlib
import signal
import subprocess
import sys
import time

import pytest

HERE = pathlib.Path(__file__).parent
ROBOT, DESK = "10.77.0.1", "10.77.0.2"
PLANES, IMAGE = "/camera/plane_segmenter/planes", "/camera/depth/image_raw"
IMAGE_BYTES = 640 * 480 * 2
FRAMES = 30


class Host:
    """A network namespace, as long as a process lives in it."""

    def __init__(self, address, unshare, enter):
        self.address = address
        self.keeper = subprocess.Popen(unshare + ["sleep", "600"], stderr=subprocess.PIPE, universal_newlines=True)
        self.prefix = enter + ["--net=/proc/%d/ns/net" % self.keeper.pid]
        self.environment = dict(os.environ, ROS_IP=address, ROS_MASTER_URI="http://%s:11311" % ROBOT)
        self.environment.pop("ROS_HOSTNAME", None)
        while self.keeper.poll() is None and self.namespace() == os.readlink("/proc/self/ns/net"):
            time.sleep(0.01)

    def namespace(self):
        try:
            return os.readlink("/proc/%d/ns/net" % self.keeper.pid)
        except OSError:
            return None

    def start(self, *command, **options):
        return subprocess.Popen(self.prefix + list(command), env=self.environment, universal_newlines=True, **options)

    def run(self, *command):
        process = self.start(*command, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        out, err = process.communicate(timeout=60)
        if process.returncode != 0:
            raise RuntimeError("%s: %s" % (" ".join(command), err.strip()))
        return out

    def received_bytes(self):
        """What came over its wire since the beginning."""
        for line in pathlib.Path("/proc/%d/net/dev" % self.keeper.pid).read_text().splitlines():
            if line.strip().startswith("wire"):
                return int(line.split(":")[1].split()[0])
        raise RuntimeError("no wire")

    def close(self):
        self.keeper.kill()
        self.keeper.wait()


def ways():
    """How a namespace is made and entered: as root, or as root of a user namespace."""
    yield ["unshare", "--net"], ["nsenter"]
    yield ["unshare", "--user", "--map-root-user", "--net"], None


def connect():
    """Two hosts and a wire between them. Skips the test where that is not allowed."""
    problems = []
    for unshare, enter in ways():
        try:
            robot = Host(ROBOT, unshare, enter or [])
        except FileNotFoundError as error:
            pytest.skip("network namespaces need unshare of util-linux: %s" % error)
        if robot.keeper.poll() is not None:
            problems.append(robot.keeper.stderr.read().strip())
            continue
        if enter is None:
            enter = ["nsenter", "--user=/proc/%d/ns/user" % robot.keeper.pid, "--preserve-credentials"]
            robot.prefix = enter + robot.prefix
        desk = Host(DESK, enter + ["unshare", "--net"], enter)
        try:
            robot.run("ip", "link", "add", "wire0", "type", "veth", "peer", "name", "wire1")
            robot.run("ip", "link", "set", "wire1", "netns", str(desk.keeper.pid))
            for host, wire in ((robot, "wire0"), (desk, "wire1")):
                host.run("ip", "link", "set", "lo", "up")
                host.run("ip", "address", "add", host.address + "/24", "dev", wire)
                host.run("ip", "link", "set", wire, "up")
            return robot, desk
        except (RuntimeError, FileNotFoundError) as error:
            problems.append(str(error))
            robot.close()
            desk.close()
    pytest.skip("network namespaces are not allowed here: " + "; ".join(problems))


@pytest.fixture
def hosts(tmp_path):
    robot, desk = connect()
    with open(str(tmp_path / "launch.log"), "w+") as log:
        launch = robot.start("roslaunch", "line_plane_segmentation", "demo.launch", "rviz:=false", "rate:=10",
                             stdout=log, stderr=subprocess.STDOUT)
        try:
            yield robot, desk
        finally:
            launch.send_signal(signal.SIGINT)
            launch.wait(60)
            log.seek(0)
            print(log.read())
            robot.close()
            desk.close()


def receive(host, topic, count):
    return host.start(sys.executable, str(HERE / "receive.py"), topic, str(count), stdout=subprocess.PIPE)


def wait_for_master(host):
    for _ in range(100):
        if host.start("rosparam", "get", "/run_id", stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).wait() == 0:
            return
        time.sleep(0.2)
    raise RuntimeError("there is no master")


def test_planes_cross_and_images_do_not(hosts):
    robot, desk = hosts
    wait_for_master(desk)

    before = desk.received_bytes()
    receiver = receive(desk, PLANES, FRAMES)
    sizes = [int(receiver.stdout.readline())]
    # While the planes leave for the desk, the image goes to the segmenter alone, and stays in the process.
    assert robot.run(sys.executable, str(HERE / "transports.py"), IMAGE).split() == ["INTRAPROCESS"]
    assert robot.run(sys.executable, str(HERE / "transports.py"), PLANES).split() == ["TCPROS"]
    sizes += [int(line) for line in receiver.communicate(timeout=60)[0].split()]
    crossed = desk.received_bytes() - before

    assert receiver.returncode == 0
    assert len(sizes) == FRAMES
    assert min(sizes) > 500, "no planes in it"
    print("%d bytes a message at most, %d bytes for %d frames" % (max(sizes), crossed, FRAMES))
    assert max(sizes) < IMAGE_BYTES / 10
    assert crossed < IMAGE_BYTES, "as much as an image"

    # The same wire, if somebody does ask for images.
    before = desk.received_bytes()
    receiver = receive(desk, IMAGE, 2)
    receiver.communicate(timeout=60)
    assert desk.received_bytes() - before > 2 * IMAGE_BYTES
