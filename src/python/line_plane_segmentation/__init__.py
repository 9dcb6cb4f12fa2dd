# SPDX-License-Identifier: BSD-3-Clause
"""Finds the planes in depth images with line primitives, after Zhang, Chen and Liu (2016).

    from line_plane_segmentation import PlaneSegmenter

    result = PlaneSegmenter().segment(depth, camera=(525.0, 525.0, 319.5, 239.5))
    for plane in result.planes:
        print(plane.label, plane.normal, plane.d, plane.area)

The messages are in line_plane_segmentation.msg, as for every ROS package.
"""
__all__ = ["Plane", "PlaneSegmenter", "Segmentation"]


def __getattr__(name):
    # Not at once: who wants nothing but the messages needs no compiled module.
    if name in __all__:
        from line_plane_segmentation import _plane_segmenter
        return getattr(_plane_segmenter, name)
    raise AttributeError("module '%s' has no attribute '%s'" % (__name__, name))


def __dir__():
    return sorted(list(globals()) + __all__)
