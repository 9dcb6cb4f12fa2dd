// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "info_history.h"
#include "input_frame.h"

namespace line_plane_segmentation {

/// Rule for pairing an image with a camera_info.
enum class InfoMatching {
  kExact,   ///< equal timestamps
  kLatest,  ///< the newest camera_info of the image's size
  kAuto,    ///< kExact while it finds pairs; otherwise the newest of the image's frame and size
};

/// Returns "exact", "latest" or "auto".
const char* nameOf(InfoMatching matching);

/// Returns the rule of this name; empty if there is none.
std::optional<InfoMatching> infoMatchingOf(const std::string& name);

/// Pairs images with camera_info messages, in any order of arrival.
///
/// Images are processed in the order of arrival, not of timestamps, which go back when a bag loops. The
/// number of waiting images is limited; if it is exceeded, the oldest is discarded and counted. Not
/// thread-safe.
class InfoMatcher {
 public:
  using TimePoint = InfoHistory::TimePoint;
  using Frames = std::vector<InputFrame>;

  /// Condition under which kAuto falls back to the newest camera_info.
  enum class FallbackRule {
    kAfterSecond,  ///< one second without a pair while images arrive
    kWhenFull,     ///< the queue of waiting images is full, or the input ends; independent of time
  };

  /// @param waiting  largest number of waiting images, at least 1
  InfoMatcher(InfoMatching matching, std::size_t waiting, FallbackRule rule = FallbackRule::kAfterSecond)
      : matching_(matching), capacity_(waiting), fallback_rule_(rule) {}

  /// Adds an image, and appends the frames that are complete.
  /// @param infos  history of the image's camera
  void addImage(const DepthMessage& image, const InfoHistory& infos, TimePoint now, Frames& frames);

  /// Processes a camera_info that was just added to `infos`, and appends the frames that are complete.
  void addInfo(const ros::Time& stamp, const InfoHistory& infos, Frames& frames);

  /// Matches the waiting images after `infos` was replaced by the history of another topic.
  void matchWaiting(const InfoHistory& infos, Frames& frames);

  /// Falls back if the waiting time has passed. To be called regularly, for input that has stopped.
  void poll(const InfoHistory& infos, TimePoint now, Frames& frames);

  /// Ends the input: appends the frames that can be paired, and counts the other images as lost.
  void finish(const InfoHistory& infos, Frames& frames);

  /// Removes the waiting images without counting them.
  void clear();

  /// Returns true if kAuto has fallen back to the newest camera_info.
  bool hasFallenBack() const { return has_fallen_back_; }

  /// Returns the number of images that were discarded without a camera_info.
  std::uint64_t lostImages() const { return lost_images_; }

  /// Returns the number of lost images whose camera_info arrived later.
  std::uint64_t lateInfos() const { return late_infos_; }

 private:
  struct Waiting {
    DepthMessage message;
    std::uint64_t number;
  };

  struct ApproximateMatch {
    ros::Time stamp;
    std::uint64_t number;
  };

  bool mustFallBack(TimePoint now) const;
  void discard(const Waiting& image);
  void fallBack(const InfoHistory& infos, Frames& frames);
  void matchNewest(const InfoHistory& infos, Frames& frames);
  void recordExactMatch(std::uint64_t number);
  sensor_msgs::CameraInfoConstPtr newestFor(const sensor_msgs::Image& image, const InfoHistory& infos) const;

  InfoMatching matching_;
  std::size_t capacity_;
  FallbackRule fallback_rule_;
  std::deque<Waiting> waiting_;
  std::deque<ApproximateMatch>
      approximate_matches_;  // last images that were paired with the newest camera_info
  std::uint64_t images_ = 0;
  std::uint64_t last_exact_ = 0;  // number of the last image that had its own camera_info
  std::optional<TimePoint> unpaired_since_;
  bool has_fallen_back_ = false;
  std::deque<ros::Time> lost_stamps_;  // timestamps of the last lost images
  std::uint64_t lost_images_ = 0;
  std::uint64_t late_infos_ = 0;
};

}  // namespace line_plane_segmentation
