// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dynamic_reconfigure/Reconfigure.h>
#include <gtest/gtest.h>
#include <line_plane_segmentation/PlaneSegmenterConfig.h>
#include <ros/service.h>

#include <functional>
#include <string>

namespace line_plane_segmentation {

/// Adds a parameter to a request. Parameters that a request does not name stay unchanged.
inline void setDouble(dynamic_reconfigure::Reconfigure& call, const std::string& name, double value) {
  dynamic_reconfigure::DoubleParameter parameter;
  parameter.name = name;
  parameter.value = value;
  call.request.config.doubles.push_back(parameter);
}

/// Adds a parameter to a request, like setDouble().
inline void setString(dynamic_reconfigure::Reconfigure& call, const std::string& name,
                      const std::string& value) {
  dynamic_reconfigure::StrParameter parameter;
  parameter.name = name;
  parameter.value = value;
  call.request.config.strs.push_back(parameter);
}

/// Sends a request to a segmenter and stores the response in `call`.
inline void reconfigure(dynamic_reconfigure::Reconfigure& call,
                        const std::string& segmenter = "plane_segmenter") {
  const std::string service = segmenter + "/set_parameters";
  EXPECT_TRUE(ros::service::waitForService(service, 15000));
  EXPECT_TRUE(ros::service::call(service, call));
}

/// Sets parameters of the segmenter under test.
/// @return the parameters in effect
inline PlaneSegmenterConfig reconfigure(const std::function<void(PlaneSegmenterConfig&)>& change) {
  PlaneSegmenterConfig config = PlaneSegmenterConfig::__getDefault__();
  change(config);
  dynamic_reconfigure::Reconfigure call;
  config.__toMessage__(call.request.config);
  reconfigure(call);
  EXPECT_TRUE(config.__fromMessage__(call.response.config));
  return config;
}

}  // namespace line_plane_segmentation
