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
#include "camera_frame.h"
#include "info_matcher.h"
#include "line_plane_segmentation/camera_intrinsics.h"
#include "rectify.h"

namespace line_plane_segmentation {

/// Which topics of a bag are depth images, and where their intrinsics come from.
struct TopicChoice {
  std::vector<std::string> images;  ///< the topics to take; empty: all that are known to hold depth
  std::vector<std::string>
      infos;  ///< their camera_info: one for all, or one for each of `images`; empty: found
  std::optional<CameraIntrinsics> camera;  ///< in the place of any camera_info
  InfoMatching matching = InfoMatching::kAuto;
  Rectify rectify = Rectify::kAuto;
};

/// A depth image topic of a bag, with statistics of its images.
struct DepthTopic {
  std::string image;             ///< without the ending of a compressed one
  std::string info;              ///< its camera_info; empty while none is known
  std::string result_namespace;  ///< namespace of its results, such as "/camera/plane_segmenter"
  InfoMatcher matcher;
  std::size_t images = 0;
  std::size_t frames = 0;    ///< number of segmented frames
  std::size_t guessed = 0;   ///< frames that went with another camera_info than that of their stamp
  std::size_t planes = 0;    ///< total over all frames
  std::size_t refused = 0;   ///< number of frames refused, by the nodelet's rules
  std::string refusal = {};  ///< reason for the last one
};

/// A frame of a bag.
struct BagFrame {
  DepthTopic* topic = nullptr;
  CameraFrame messages;
  ros::Time time;  ///< when it was whole: the recording time of the message that made it so
};

/// Selects the depth topics of a bag and pairs their images with camera_info, like the nodelet.
///
/// Without named topics these are depth: 16UC1 and 32FC1 images, plain or compressed, and mono16 images whose
/// topic says "depth"; infrared images are mono16, too. Label images of a segmenter are not.
class DepthTopics {
 public:
  explicit DepthTopics(TopicChoice choice) : choice_(std::move(choice)) {}

  /// Tells what the bag holds, as far as that is known before it is read.
  /// @param types  data types by topic
  void setBagTopics(const std::map<std::string, std::string>& types) { types_ = types; }

  /// Returns whether messages of this kind are of use to add().
  bool wants(const std::string& topic, const std::string& datatype) const;

  /// Adds a message, and appends the frames that it completes.
  /// @throws std::exception if it cannot be deserialised
  void add(const BagMessage& message, std::deque<BagFrame>& frames);

  /// At the end of the bag: appends the frames that still can be made.
  void finish(std::deque<BagFrame>& frames);

  /// Topics found so far, in order of their first message.
  const std::list<DepthTopic>& all() const { return topics_; }

  /// The image topics that were left out, with their encodings: {"/camera/rgb/image_raw", "rgb8"}.
  const std::map<std::string, std::string>& others() const { return others_; }

  /// The topics that camera_infos came on.
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
  std::map<std::string, InfoHistory> infos_;     // by their topic
  InfoHistory no_infos_;
  std::map<std::string, std::string> others_;
  ros::Time last_time_;
};

/// Returns the camera_info topic beside an image topic.
std::string infoTopicOf(const std::string& image_topic);

/// Returns where the nodelet's launch files put the planes of an image topic: beside the folder of the image,
/// "/camera/plane_segmenter" for "/camera/depth/image_raw".
std::string resultNamespaceOf(const std::string& image_topic);

}  // namespace line_plane_segmentation
