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

/// A message of a bag, still serialised.
struct BagMessage {
  std::string topic;
  ros::Time time;  ///< when it was recorded
  topic_tools::ShapeShifter::ConstPtr content;
  boost::shared_ptr<ros::M_string> connection;  ///< header of the connection that it came over
};

/// Says from topic and data type whether messages are wanted.
using MessageFilter = std::function<bool(const std::string& topic, const std::string& datatype)>;

/// The messages of a bag, one after the other. What cannot be read is passed over and remembered.
class BagInput {
 public:
  virtual ~BagInput() = default;

  /// @return false when there are no more
  virtual bool next(BagMessage& message) = 0;

  /// How much of the bag was read, 0 to 1.
  virtual double share() const = 0;

  /// The data types of all topics as far as they are known before reading: empty if the bag has no index.
  virtual const std::map<std::string, std::string>& topics() const = 0;

  /// What is wrong with the bag, as far as it was read; empty: nothing.
  virtual const std::string& damage() const = 0;
};

/// Opens a bag: in the order of recording times where it has an index, else in that of the file, as far as it
/// is whole.
/// @throws BadInput if there is no such file or it is no bag
std::unique_ptr<BagInput> openBag(const std::filesystem::path& file, const MessageFilter& wanted);

/// A bag whose index is missing or wrong: the recording was not finished, or the file was cut off. rosbag's
/// C++ library reads no such bag, so this goes through its records itself (wiki.ros.org/Bags/Format/2.0).
/// @param damage  what is known about it
std::unique_ptr<BagInput> openDamagedBag(const std::filesystem::path& file, const MessageFilter& wanted,
                                         const std::string& damage);

}  // namespace line_plane_segmentation
