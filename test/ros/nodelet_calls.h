// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nodelet/NodeletLoad.h>
#include <nodelet/NodeletUnload.h>
#include <ros/service.h>

#include <string>

namespace line_plane_segmentation {

/// Loads a segmenter into the nodelet manager /manager.
inline bool loadSegmenter(const std::string& name) {
  nodelet::NodeletLoad call;
  call.request.name = name;
  call.request.type = "line_plane_segmentation/plane_segmenter";
  return ros::service::call("/manager/load_nodelet", call) && call.response.success;
}

/// Unloads the segmenter.
inline bool unloadSegmenter(const std::string& name) {
  nodelet::NodeletUnload call;
  call.request.name = name;
  return ros::service::call("/manager/unload_nodelet", call) && call.response.success;
}

}  // namespace line_plane_segmentation
