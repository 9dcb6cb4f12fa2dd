// SPDX-License-Identifier: BSD-3-Clause
#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.hpp>

#include "plane_segmenter_nodelet.h"

PLUGINLIB_EXPORT_CLASS(line_plane_segmentation::PlaneSegmenterNodelet, nodelet::Nodelet)
