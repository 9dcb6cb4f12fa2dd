// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>
#include <rosbag/bag.h>

#include <algorithm>
#include <cerrno>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>

#include "bag_input.h"
#include "run_tool.h"

namespace line_plane_segmentation {

/// Writer of a bag.
class BagOutput {
 public:
  /// @param file  where it is written
  /// @param name  its name in error messages
  /// @throws BadInput if the file cannot be written
  BagOutput(const std::filesystem::path& file, std::string name, rosbag::CompressionType compression);

  /// If close() was not called, the file is not a valid bag.
  ~BagOutput();
  BagOutput(const BagOutput&) = delete;
  BagOutput& operator=(const BagOutput&) = delete;

  /// @throws BadInput if the disk is full
  template <typename Message>
  void write(const std::string& topic, const ros::Time& time, const Message& message) {
    guarded([&] { bag_->write(topic, std::max(time, ros::TIME_MIN), message); });
  }

  /// Copies a serialised message.
  /// @throws BadInput if the disk is full
  void copy(const BagMessage& message) {
    guarded([&] {
      bag_->write(message.topic, std::max(message.time, ros::TIME_MIN), *message.content, message.connection);
    });
  }

  /// @throws BadInput if the disk is full
  void close();

 private:
  template <typename Action>
  void guarded(Action&& action) {
    errno = 0;
    try {
      action();
    } catch (const std::exception& error) {
      giveUp(error.what(), errno);
    }
  }

  [[noreturn]] void giveUp(const std::string& problem, int error);

  std::string name_;
  std::unique_ptr<rosbag::Bag> bag_;
};

}  // namespace line_plane_segmentation
