// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dynamic_reconfigure/Reconfigure.h>
#include <gtest/gtest.h>
#include <line_plane_segmentation/PlaneSegmenterConfig.h>
#include <ros/service.h>

#include <functional>

namespace line_plane_segmentation {

/// Asks the segmenter under test for other parameters than the defaults.
/// @return what it made of them
inline PlaneSegmenterConfig reconfigure(const std::function<void(PlaneSegmenterConfig&)>& change) {
  PlaneSegmenterConfig config = PlaneSegmenterConfig::__getDefault__();
  change(config);
  dynamic_reconfigure::Reconfigure call;
  config.__toMessage__(call.request.config);
  EXPECT_TRUE(ros::service::waitForService("plane_segmenter/set_parameters", 15000));
  EXPECT_TRUE(ros::service::call("plane_segmenter/set_parameters", call));
  EXPECT_TRUE(config.__fromMessage__(call.response.config));
  return config;
}

}  // namespace line_plane_segmentation
