# SPDX-License-Identifier: BSD-3-Clause
"""Finds the planes in depth images with line primitives, after Zhang, Chen and Liu (2016).

    from line_plane_segmentation import PlaneSegmenter

    result = PlaneSegmenter().segment(depth, camera=(525.0, 525.0, 319.5, 239.5))
    for plane in result.planes:
        print(plane.label, plane.normal, plane.d, plane.area)

PlaneTracker gives planes ids that stay from image to image; overlay() makes a picture of a result. Where the package
is built with ROS, the messages are in line_plane_segmentation.msg.
"""
import importlib
import pkgutil

# In a devel space the compiled module and the messages lie in another folder than this file. A process that
# multiprocessing spawns finds this one first, since catkin put it first on the path of its parent.
__path__ = pkgutil.extend_path(__path__, __name__)

_MODULES = {
    "Plane": "_plane_segmenter",
    "PlaneSegmenter": "_plane_segmenter",
    "PlaneTracker": "_plane_segmenter",
    "Segmentation": "_plane_segmenter",
    "color_of": "_plane_segmenter",
    "overlay": "_overlay",
    "__abi__": "_plane_segmenter",
    "__version__": "_plane_segmenter",
}

__all__ = [name for name in _MODULES if not name.startswith("_")]


def __getattr__(name):
    # Not at once: programs that need nothing but the messages need no compiled module.
    if name in _MODULES:
        return getattr(importlib.import_module(__name__ + "." + _MODULES[name]), name)
    raise AttributeError("module '%s' has no attribute '%s'" % (__name__, name))


def __dir__():
    return sorted(list(globals()) + list(_MODULES))
