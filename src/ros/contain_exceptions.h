// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/console.h>

#include <exception>
#include <string>

namespace line_plane_segmentation {

/// Calls what ROS calls back. An exception ends here, in the log: in the threads of a nodelet manager it
/// would end the manager and all that it has loaded.
/// @param name  of whoever is called back, for the log
template <typename Callback>
void containExceptions(const std::string& name, Callback&& callback) noexcept {
  try {
    try {
      callback();
    } catch (const std::exception& exception) {
      ROS_ERROR("[%s] a callback failed: %s", name.c_str(), exception.what());
    }
  } catch (...) {
    // Of unknown type, or there was no memory to log it.
    return;
  }
}

}  // namespace line_plane_segmentation
