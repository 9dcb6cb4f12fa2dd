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

/// Writer of a bag. Converts rosbag's exceptions to BadInput.
class BagOutput {
 public:
  /// Opens the file.
  /// @param file  file to write
  /// @param name  name of the bag in error messages
  /// @throws BadInput if the file cannot be written
  BagOutput(const std::filesystem::path& file, std::string name, rosbag::CompressionType compression);

  /// Closes the file. It is a valid bag only if close() was called before.
  ~BagOutput();
  BagOutput(const BagOutput&) = delete;
  BagOutput& operator=(const BagOutput&) = delete;

  /// Serialises and writes a message.
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

  /// Writes the index and closes the bag.
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
