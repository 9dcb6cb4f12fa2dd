// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/console.h>

#include <exception>
#include <string>

namespace line_plane_segmentation {

/// Runs a callback and logs its exceptions. In a thread of a nodelet manager, an exception would terminate
/// the manager with all its nodelets.
/// @param name  name for the log
template <typename Callback>
void logExceptions(const std::string& name, Callback&& callback) noexcept {
  try {
    try {
      callback();
    } catch (const std::exception& exception) {
      ROS_ERROR("[%s] a callback failed: %s", name.c_str(), exception.what());
    }
  } catch (...) {
    // Unknown type, or out of memory while logging.
    return;
  }
}

}  // namespace line_plane_segmentation
