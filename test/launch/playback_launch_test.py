#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""playback.launch: every image of a bag is answered, from the first one on, also with what segment_bag answered."""
import array
import copy
import io
import os
import signal
import struct
import subprocess
import tempfile
import threading
import time
import unittest
import zlib

import genpy
import rosbag
import rosnode
import rospy
import rostest
from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import CameraInfo, CompressedImage, Image
from tf2_msgs.msg import TFMessage

from line_plane_segmentation.msg import PlaneArray

WIDTH, HEIGHT, FOCAL_LENGTH = 320, 240, 285.0
FRAMES = 30
# Slower than a camera: what is tested is that playing waits, not how fast the machine is.
FRAMES_PER_SECOND = 10
DEPTH_TOPIC = "depth_topic:=/kinect/depth/image_raw"
PLANES = "/camera/plane_segmenter/planes"
CAMERA_FRAME = "camera_depth_optical_frame"


def wall():
    """A wall across the view, 2 m away, in millimetres."""
    return array.array("H", [2000] * (WIDTH * HEIGHT)).tobytes()


def compressed(image):
    """The same image as the plugin compressedDepth sends it: a header of 12 bytes and a PNG."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    row = b"\0" + array.array("H", struct.pack(">H", 2000) * WIDTH).tobytes()
    png = (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", WIDTH, HEIGHT, 16, 0, 0, 0, 0)) +
           chunk(b"IDAT", zlib.compress(row * HEIGHT)) + chunk(b"IEND", b""))
    return CompressedImage(header=image.header, format="16UC1; compressedDepth", data=bytes(12) + png)


def write_bag(path, namespace, is_compressed=False):
    """A bag of FRAMES depth images, with tf and with a topic that nobody listens to. Returns the images' stamps."""
    image = Image(height=HEIGHT, width=WIDTH, encoding="16UC1", step=2 * WIDTH, data=wall())
    info = CameraInfo(height=HEIGHT, width=WIDTH, distortion_model="plumb_bob", D=[0.0] * 5)
    info.K = [FOCAL_LENGTH, 0, WIDTH / 2, 0, FOCAL_LENGTH, HEIGHT / 2, 0, 0, 1]
    info.R = [1, 0, 0, 0, 1, 0, 0, 0, 1]
    info.P = [FOCAL_LENGTH, 0, WIDTH / 2, 0, 0, FOCAL_LENGTH, HEIGHT / 2, 0, 0, 0, 1, 0]
    mount = TransformStamped(child_frame_id=CAMERA_FRAME)
    mount.header.frame_id = "world"
    mount.transform.rotation.w = 1.0

    stamps = [genpy.Time(1000) + genpy.Duration.from_sec(i / FRAMES_PER_SECOND) for i in range(FRAMES)]
    with rosbag.Bag(path, "w") as bag:
        for stamp in stamps:
            for message in (image, info, mount):
                message.header.stamp = stamp
            image.header.frame_id = info.header.frame_id = CAMERA_FRAME
            bag.write("/tf", TFMessage([mount]), stamp)
            if is_compressed:
                bag.write(namespace + "/image_raw/compressedDepth", compressed(image), stamp)
            else:
                bag.write(namespace + "/image_raw", image, stamp)
            bag.write(namespace + "/camera_info", info, stamp)
            bag.write("/unheard", info, stamp)
    return stamps


def comparable(message):
    """The bytes of a PlaneArray but for what differs from run to run: the time that it took, and ROS's own seq."""
    copy_of_it = copy.deepcopy(message)
    copy_of_it.processing_time = copy_of_it.processing_seconds = 0
    copy_of_it.header.seq = 0
    buffer = io.BytesIO()
    copy_of_it.serialize(buffer)
    return buffer.getvalue()


class PlaybackLaunchTest(unittest.TestCase):
    def wait_for_publisher(self, topic):
        deadline = time.monotonic() + 60
        while topic not in [name for name, _ in rospy.get_published_topics()]:
            self.assertLess(time.monotonic(), deadline, "nobody publishes " + topic)
            rospy.rostime.wallsleep(0.1)

    def play(self, folder, bag, *options):
        """The answers to a bag of this folder, played by playback.launch without a window, and the nodes meanwhile."""
        arrays = []
        enough = threading.Event()

        def collect(message):
            arrays.append(message)
            if len(arrays) >= FRAMES:
                enough.set()

        command = ["roslaunch", "line_plane_segmentation", "playback.launch", "rviz:=false", "bag:=" + bag]
        launch = subprocess.Popen(command + list(options), cwd=folder, env=dict(os.environ, PWD=folder))
        try:
            self.wait_for_publisher(PLANES)
            # Had playing begun by itself, these would be lost.
            rospy.rostime.wallsleep(2.0)
            subscriber = rospy.Subscriber(PLANES, PlaneArray, collect, queue_size=FRAMES)
            enough.wait(30)
            rospy.rostime.wallsleep(1.0)
            nodes = rosnode.get_node_names()
            subscriber.unregister()
        finally:
            launch.send_signal(signal.SIGINT)
            launch.wait(30)
        return arrays, nodes

    def test_every_image_is_answered_as_by_segment_bag(self):
        with tempfile.TemporaryDirectory() as folder:
            stamps = write_bag(os.path.join(folder, "a wall.bag"), "/kinect/depth")
            arrays, _ = self.play(folder, "a wall.bag", DEPTH_TOPIC)
            self.assertFalse(rospy.has_param("/use_sim_time"), "it is left behind")
            subprocess.run(["rosrun", "line_plane_segmentation", "segment_bag", "a wall.bag", "out.bag"], cwd=folder,
                           check=True)
            with rosbag.Bag(os.path.join(folder, "out.bag")) as out:
                expected = [message for _, message, _ in out.read_messages("/kinect/plane_segmenter/planes", raw=False)]
        self.assertEqual(stamps, [message.header.stamp for message in arrays])
        self.assertEqual(list(map(comparable, expected)), list(map(comparable, arrays)))
        for message in arrays:
            self.assertEqual((WIDTH, HEIGHT), (message.image_width, message.image_height))
            self.assertEqual(1, len(message.planes), "one wall")

    def test_compressed_images_are_played(self):
        with tempfile.TemporaryDirectory() as folder:
            stamps = write_bag(os.path.join(folder, "in.bag"), "/kinect/depth", is_compressed=True)
            arrays, _ = self.play(folder, "in.bag", DEPTH_TOPIC + "/compressedDepth")
        self.assertEqual(stamps, [message.header.stamp for message in arrays])
        for message in arrays:
            self.assertEqual(1, len(message.planes), "one wall")
            self.assertAlmostEqual(2.0, message.planes[0].coefficients.coef[3], delta=0.01)

    def test_wrong_input_is_refused_before_anything_starts(self):
        with tempfile.TemporaryDirectory() as folder:
            write_bag(os.path.join(folder, "in.bag"), "/kinect/depth")
            for arguments, complaint in (
                    (["bag:=in.bag"], "it has no topic /camera/depth/image_raw and no topic /camera/depth/camera_info. "
                                      "Its images and clouds: /kinect/depth/image_raw; its camera_info: "
                                      "/kinect/depth/camera_info /unheard"),
                    (["bag:=in.bag", DEPTH_TOPIC, "segmented:=true"],
                     "it has no topic /kinect/plane_segmenter/planes"),
                    (["bag:=out.bag"], "No such file"),
                    (["bag:=in.bag", "dept_topic:=/x"], "no argument 'dept_topic'; did you mean 'depth_topic'?")):
                result = subprocess.run(["roslaunch", "line_plane_segmentation", "playback.launch", "rviz:=false"] + arguments,
                                        cwd=folder, env=dict(os.environ, PWD=folder), timeout=60, stdout=subprocess.PIPE,
                                        stderr=subprocess.STDOUT, universal_newlines=True)
                self.assertEqual(1, result.returncode, result.stdout)
                self.assertIn(complaint, result.stdout)
                self.assertNotIn("process[", result.stdout)

    def test_what_segment_bag_made_is_shown(self):
        with tempfile.TemporaryDirectory() as folder:
            stamps = write_bag(os.path.join(folder, "in.bag"), "/kinect/depth")
            subprocess.run(["rosrun", "line_plane_segmentation", "segment_bag", "in.bag", "out.bag", "--all", "--set",
                            "max_range=1.9"], cwd=folder, check=True)
            arrays, nodes = self.play(folder, "out.bag", DEPTH_TOPIC, "segmented:=true")
        self.assertEqual(stamps, [message.header.stamp for message in arrays])
        for message in arrays:
            self.assertEqual(0, len(message.planes), "the wall is beyond the range: a segmenter here would find it")
        self.assertNotIn("/camera/plane_segmenter", nodes)


if __name__ == "__main__":
    rospy.init_node("playback_launch_test")
    rostest.rosrun("line_plane_segmentation", "playback_launch", PlaybackLaunchTest)
