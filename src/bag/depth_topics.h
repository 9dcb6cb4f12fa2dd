// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <deque>
#include <list>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "bag_input.h"
#include "stamp_pairing.h"

namespace line_plane_segmentation {

/// A depth image topic of a bag and what became of its images.
struct DepthTopic {
  std::string image;
  std::string info;              ///< the camera_info beside it
  std::string result_namespace;  ///< where its results go, "/camera/plane_segmenter"
  StampPairing pairing;
  std::size_t images = 0;
  std::size_t frames = 0;   ///< segmented
  std::size_t planes = 0;   ///< of all frames
  std::size_t refused = 0;  ///< frames, as the nodelet would
  std::string refusal;      ///< why the last one was
};

/// A frame of a bag.
struct BagFrame {
  DepthTopic* topic = nullptr;
  CameraFrame messages;
  ros::Time time;  ///< when it was whole: the later recording time of its two messages
};

/// Picks the depth topics of a bag and pairs their images with camera_info, as the nodelet does.
class DepthTopics {
 public:
  /// @param named  the topics to take; none: all whose first image is 16UC1 or 32FC1, except a segmenter's
  /// labels.
  ///               mono16, which infrared images are, too, is taken for depth only where it is named.
  explicit DepthTopics(std::vector<std::string> named) : named_(std::move(named)) {}

  /// If messages of this kind are of use to add().
  bool wants(const std::string& topic, const std::string& datatype) const;

  /// Takes a message; appends the frames that it makes whole.
  /// @throws std::exception if its content is broken
  void add(const BagMessage& message, std::deque<BagFrame>& frames);

  /// Those found so far, in the order in which they were first seen.
  const std::list<DepthTopic>& all() const { return topics_; }

  /// The image topics that were left out, with their encodings: "/camera/rgb/image_raw (rgb8)".
  const std::set<std::string>& others() const { return others_; }

 private:
  void addImage(const BagMessage& message, std::deque<BagFrame>& frames);
  void addInfo(const BagMessage& message, std::deque<BagFrame>& frames);
  DepthTopic* findOrPick(const std::string& topic, const std::string& encoding);

  std::vector<std::string> named_;
  std::list<DepthTopic> topics_;                 // a list: frames point to its elements
  std::map<std::string, DepthTopic*> by_image_;  // null: no depth topic
  std::map<std::string, std::deque<sensor_msgs::CameraInfoConstPtr>> early_infos_;  // by their topic
  std::set<std::string> others_;
};

/// The topic of the camera_info that belongs to an image topic.
std::string infoTopicOf(const std::string& image_topic);

/// Where the nodelet's launch files have it put the planes of an image topic: beside the folder of the image,
/// "/camera/plane_segmenter" for "/camera/depth/image_raw".
std::string resultNamespaceOf(const std::string& image_topic);

}  // namespace line_plane_segmentation
