# SPDX-License-Identifier: BSD-3-Clause
from line_plane_segmentation._overlay import overlay as overlay
from line_plane_segmentation._plane_segmenter import (
    Plane as Plane,
    PlaneSegmenter as PlaneSegmenter,
    PlaneTracker as PlaneTracker,
    Segmentation as Segmentation,
    color_of as color_of,
)

__version__: str
__abi__: str
