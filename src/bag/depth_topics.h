// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <deque>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bag_input.h"
#include "info_matcher.h"
#include "input_frame.h"
#include "line_plane_segmentation/camera_intrinsics.h"
#include "rectification_mode.h"

namespace line_plane_segmentation {

/// Selection of the depth image topics of a bag and of the source of their intrinsics.
struct TopicChoice {
  std::vector<std::string> images;  ///< selected topics; empty: all topics that are known to hold depth
  std::vector<std::string>
      infos;  ///< camera_info topics: one for all, or one per element of `images`; empty: automatic
  std::optional<CameraIntrinsics> camera;  ///< intrinsics to use instead of camera_info
  InfoMatching matching = InfoMatching::kAuto;
  RectificationMode rectify = RectificationMode::kAuto;
};

/// A depth image topic of a bag, with statistics of its images.
struct DepthTopic {
  std::string image;             ///< topic without the suffix of a compressed one
  std::string info;              ///< topic of its camera_info; empty while unknown
  std::string result_namespace;  ///< namespace of its results, such as "/camera/plane_segmenter"
  InfoMatcher matcher;
  std::size_t images = 0;
  std::size_t frames = 0;       ///< number of segmented frames
  std::size_t approximate = 0;  ///< number of frames paired with a camera_info of another timestamp
  std::size_t planes = 0;       ///< total over all frames
  std::size_t refused = 0;      ///< number of frames refused, by the nodelet's rules
  std::string refusal = {};     ///< reason for the last one
};

/// A frame of a bag.
struct BagFrame {
  DepthTopic* topic = nullptr;
  InputFrame messages;
  ros::Time time;  ///< recording time of the message that completed it
};

/// Selects the depth topics of a bag and pairs their images with camera_info, like the nodelet.
///
/// If no topics are selected, these are depth images: 16UC1 and 32FC1, plain or compressed, and mono16 if the
/// topic contains "depth", because infrared images are mono16, too. Label images of a segmenter are excluded.
class DepthTopics {
 public:
  explicit DepthTopics(TopicChoice choice) : choice_(std::move(choice)) {}

  /// Sets the topics of the bag, as far as they are known before reading.
  /// @param types  data types by topic
  void setBagTopics(const std::map<std::string, std::string>& types) { types_ = types; }

  /// Returns true if add() uses messages of this topic and type.
  bool wants(const std::string& topic, const std::string& datatype) const;

  /// Adds a message, and appends the frames that it completes.
  /// @throws std::exception if it cannot be deserialised
  void add(const BagMessage& message, std::deque<BagFrame>& frames);

  /// Ends the input: appends the remaining frames that can be paired.
  void finish(std::deque<BagFrame>& frames);

  /// Returns the topics found so far, in the order of their first message.
  const std::list<DepthTopic>& all() const { return topics_; }

  /// Returns the image topics that are not depth, with their encodings: {"/camera/rgb/image_raw", "rgb8"}.
  const std::map<std::string, std::string>& others() const { return others_; }

  /// Returns the topics of all camera_info messages read so far.
  std::vector<std::string> infoTopics() const;

 private:
  void addImage(const BagMessage& message, std::deque<BagFrame>& frames);
  void addInfo(const BagMessage& message, std::deque<BagFrame>& frames);
  DepthTopic* findOrPick(const std::string& topic, const sensor_msgs::Image& image);
  bool isNamed(const std::string& image_topic) const;
  std::string infoTopicFor(const std::string& image_topic) const;
  bool findInfoTopic(DepthTopic& topic, const sensor_msgs::Image& image) const;
  void append(DepthTopic& topic, InfoMatcher::Frames& whole, const ros::Time& time,
              std::deque<BagFrame>& frames);
  const InfoHistory& infosOf(const DepthTopic& topic) const;

  TopicChoice choice_;
  std::map<std::string, std::string> types_;
  std::list<DepthTopic> topics_;                 // a list, since frames hold pointers to its elements
  std::map<std::string, DepthTopic*> by_image_;  // null: not a depth topic
  std::map<std::string, InfoHistory> infos_;     // by topic
  InfoHistory no_infos_;
  std::map<std::string, std::string> others_;
  ros::Time last_time_;
};

/// Returns the camera_info topic beside an image topic.
std::string infoTopicOf(const std::string& image_topic);

/// Returns the namespace that the launch files use for the results of an image topic:
/// "/camera/plane_segmenter" for "/camera/depth/image_raw".
std::string resultNamespaceOf(const std::string& image_topic);

}  // namespace line_plane_segmentation
