#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Segments a folder of 16-bit depth images with the workers of a dask cluster and writes one row for each plane.

    segment_folder.py --camera 525,525,319.5,239.5 --depth-unit 0.001 FOLDER PLANES.csv

Without --scheduler it starts --workers processes on this machine. With --scheduler ADDRESS it uses a cluster that runs
already; its workers need this Python module and must see FOLDER by the same path.

The order and the values of the rows do not depend on the number of workers.
"""
import argparse
import csv
import os
import sys

import numpy as np
from dask.distributed import Client, get_worker
from PIL import Image

from line_plane_segmentation import PlaneSegmenter

COLUMNS = ("image", "label", "nx", "ny", "nz", "d", "inliers", "rms", "area")


def segmenter_of_this_worker():
    """A segmenter for each worker thread: it keeps its memory from image to image."""
    worker = get_worker()
    if not hasattr(worker, "plane_segmenter"):
        worker.plane_segmenter = PlaneSegmenter()
    return worker.plane_segmenter


def rows_of(segmenter, path, camera, depth_unit):
    with Image.open(path) as image:
        depth = np.asarray(image).astype(np.uint16)
    result = segmenter.segment(depth, camera, depth_unit)
    return [(os.path.basename(path), p.label, *(repr(float(c)) for c in p.normal), repr(p.d), p.inliers, repr(p.rms),
             repr(p.area)) for p in result.planes]


def rows_in_worker(path, camera, depth_unit):
    return rows_of(segmenter_of_this_worker(), path, camera, depth_unit)


def images_in(folder):
    return sorted(os.path.join(folder, name) for name in os.listdir(folder) if name.endswith(".png"))


def segment(client, folder, camera, depth_unit):
    """The rows of all images, in the order of their names."""
    futures = client.map(rows_in_worker, images_in(folder), camera=camera, depth_unit=depth_unit)
    return [row for rows in client.gather(futures) for row in rows]


def write(path, rows):
    with open(path, "w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream)
        writer.writerow(COLUMNS)
        writer.writerows(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("planes")
    parser.add_argument("--camera", required=True, metavar="FX,FY,CX,CY")
    parser.add_argument("--depth-unit", type=float, default=0.001)
    parser.add_argument("--workers", type=int, default=os.cpu_count(), help="processes on this machine")
    parser.add_argument("--scheduler", help="address of a running dask scheduler, tcp://HOST:8786")
    arguments = parser.parse_args()
    camera = [float(number) for number in arguments.camera.split(",")]

    # One thread each: the segmenter is shared by a worker's tasks, and a process for each core needs no lock.
    cluster = (dict(address=arguments.scheduler) if arguments.scheduler
               else dict(n_workers=arguments.workers, threads_per_worker=1, dashboard_address=None))
    with Client(**cluster) as client:
        rows = segment(client, os.path.abspath(arguments.folder), camera, arguments.depth_unit)
        print("%d planes in %d images, by %d workers" % (
            len(rows), len(images_in(arguments.folder)), len(client.scheduler_info()["workers"])))
    write(arguments.planes, rows)


if __name__ == "__main__":
    sys.exit(main())
