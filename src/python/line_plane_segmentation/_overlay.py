# SPDX-License-Identifier: BSD-3-Clause
"""The picture of a segmentation."""
import numpy as np

from line_plane_segmentation._plane_segmenter import color_of

_COLOR_FRACTION = 0.6
_NEAREST_GREY, _FARTHEST_GREY, _INVALID_GREY = 235.0, 70.0, 24.0


def overlay(depth, labels):
    """overlay(depth, labels) -> uint8 array (height, width, 3), red, green, blue

    The depth image in grey, near light and far dark, with each plane tinted in its colour: color_of(label).

    depth: array (height, width) of numbers in any unit; 0, negative and not finite: invalid. Masked pixels of a
        numpy.ma array are invalid.
    labels: array of that shape, 0 = no plane: Segmentation.labels, or an image of ids in their place.

    Raises ValueError if the shapes differ.
    """
    depth = np.asarray(np.ma.filled(depth, 0), dtype=np.float64)
    labels = np.asarray(labels)
    if depth.ndim != 2 or depth.shape != labels.shape:
        raise ValueError("depth and labels must have the same two dimensions, not %s and %s"
                         % (depth.shape, labels.shape))
    valid = np.isfinite(depth) & (depth > 0.0)
    grey = np.full(depth.shape, _INVALID_GREY)
    if valid.any():
        # Without the nearest and farthest hundredth, which would take all the contrast.
        nearest, farthest = np.percentile(depth[valid], (1.0, 99.0))
        fraction = np.clip((depth[valid] - nearest) / max(farthest - nearest, 1e-9), 0.0, 1.0)
        grey[valid] = _NEAREST_GREY + fraction * (_FARTHEST_GREY - _NEAREST_GREY)

    picture = np.repeat(grey[:, :, np.newaxis], 3, axis=2)
    for label in np.unique(labels[labels != 0]):
        pixels = labels == label
        picture[pixels] = (_COLOR_FRACTION * np.array(color_of(int(label)))
                           + (1.0 - _COLOR_FRACTION) * picture[pixels])
    return picture.astype(np.uint8)
