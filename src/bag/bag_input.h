// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>
#include <topic_tools/shape_shifter.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>

namespace line_plane_segmentation {

/// Serialised message of a bag.
struct BagMessage {
  std::string topic;
  ros::Time time;  ///< time of recording
  topic_tools::ShapeShifter::ConstPtr content;
  boost::shared_ptr<ros::M_string> connection;  ///< fields of its connection header
};

/// Decides by topic and data type whether messages are read.
using MessageFilter = std::function<bool(const std::string& topic, const std::string& datatype)>;

/// Iterates over the messages of a bag. Unreadable parts are skipped and recorded as damage.
class BagInput {
 public:
  virtual ~BagInput() = default;

  /// @return false at the end of the bag
  virtual bool next(BagMessage& message) = 0;

  /// Returns the fraction of the bag that was read, 0 to 1.
  virtual double fractionRead() const = 0;

  /// Returns the data type per topic, as far as known before reading. Empty if the bag has no index.
  virtual const std::map<std::string, std::string>& topics() const = 0;

  /// Returns a description of the damage found so far; empty if none.
  virtual const std::string& damage() const = 0;
};

/// Opens a bag. With an index, messages are read in the order of recording; otherwise in the order of the
/// file, up to the first damage.
/// @throws BadInput if the file does not exist or is not a bag
std::unique_ptr<BagInput> openBag(const std::filesystem::path& file, const MessageFilter& wanted);

/// Opens a bag whose index is missing or wrong, because the recording was not finished or the file is
/// truncated. rosbag's C++ library cannot read such a bag, so its records are parsed here
/// (wiki.ros.org/Bags/Format/2.0).
/// @param damage  description of the damage known so far
std::unique_ptr<BagInput> openDamagedBag(const std::filesystem::path& file, const MessageFilter& wanted,
                                         const std::string& damage);

}  // namespace line_plane_segmentation
