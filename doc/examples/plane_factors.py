#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints how certain the measurements of each plane are, from the table that record_planes.py writes.

The covariance of (n, d) has rank 3, because n has length 1. minimal() gives the 3 x 3 covariance that a SLAM back end needs.
"""
import argparse
import csv
from collections import defaultdict

import numpy as np


def tangent(normal):
    """Two unit vectors that are orthogonal to the normal and to each other, as rows."""
    return np.linalg.svd(normal.reshape(1, 3))[2][1:]


def minimal(normal, covariance):
    """Covariance of (rotation [rad], rotation [rad], d [m]), from that of (n, d)."""
    jacobian = np.zeros((3, 4))
    jacobian[:2, :3] = tangent(normal)
    jacobian[2, 3] = 1.0
    return jacobian @ covariance @ jacobian.T


def read(path):
    """Yields id, (n, d) and covariance of each row."""
    with open(path, newline="") as table:
        for row in csv.DictReader(table):
            coefficients = np.array([float(row[name]) for name in ("nx", "ny", "nz", "d")])
            covariance = np.array([float(row["c%d%d" % (i, j)]) for i in range(4) for j in range(4)]).reshape(4, 4)
            yield int(row["id"]), coefficients, covariance


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("file", help="the table")
    landmarks = defaultdict(list)
    for landmark, coefficients, covariance in read(parser.parse_args().file):
        landmarks[landmark].append(minimal(coefficients[:3], covariance))
    for landmark, covariances in sorted(landmarks.items()):
        mean = np.mean(covariances, axis=0)
        np.linalg.inv(mean)  # it has full rank
        print("landmark %d: %d measurements, normal %.2f deg, distance %.1f mm" %
              (landmark, len(covariances), np.degrees(np.sqrt(np.trace(mean[:2, :2]))), 1000.0 * np.sqrt(mean[2, 2])))


if __name__ == "__main__":
    main()
