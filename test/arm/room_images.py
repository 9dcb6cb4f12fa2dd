#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Images for scripts/test_arm_tools, in three steps that run on two processors.

Usage: room_images.py write FOLDER <ROOMS      the images of write_test_rooms as ROOM.png and ROOM.npy
       room_images.py segment FOLDER OUT       the labels of each ROOM.npy by the Python module, as OUT/ROOM.npy
       room_images.py compare OUT LABELS       fails unless each OUT/ROOM.npy is LABELS/ROOM.labels.png
"""

import pathlib
import sys

import numpy as np


def camera_of(shape):
    """The intrinsics of segment_test_rooms."""
    height, width = shape
    focal_length = 525.0 * width / 640.0
    return focal_length, focal_length, (width - 1) / 2.0, (height - 1) / 2.0


def write(folder):
    from PIL import Image

    count = 0
    for line in iter(sys.stdin.buffer.readline, b""):
        width, height = map(int, line.split())
        depth = np.frombuffer(sys.stdin.buffer.read(2 * width * height), np.uint16).reshape(height, width)
        count += 1
        Image.fromarray(depth).save(folder / ("room_%d.png" % count))
        np.save(folder / ("room_%d.npy" % count), depth)


def segment(folder, out):
    from line_plane_segmentation import PlaneSegmenter

    segmenter = PlaneSegmenter()
    for file in sorted(folder.glob("room_*.npy")):
        depth = np.load(file)
        np.save(out / file.name, segmenter.segment(depth, camera_of(depth.shape)).labels)


def compare(out, labels):
    from PIL import Image

    files = sorted(out.glob("room_*.npy"))
    if not files:
        raise SystemExit("no labels to compare")
    for file in files:
        expected = np.asarray(Image.open(labels / (file.stem + ".labels.png")))
        if expected.max() == 0 or not np.array_equal(expected, np.load(file)):
            raise SystemExit("%s: other labels than %s.labels.png" % (file, file.stem))


if __name__ == "__main__":
    {"write": write, "segment": segment, "compare": compare}[sys.argv[1]](*map(pathlib.Path, sys.argv[2:]))
