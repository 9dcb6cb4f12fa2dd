// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "camera_frame.h"
#include "info_history.h"

namespace line_plane_segmentation {

/// How an image finds its camera_info.
enum class InfoMatching {
  kExact,   ///< by exactly the same stamp
  kLatest,  ///< the newest of the image's size
  kAuto,    ///< kExact while that finds pairs, otherwise the newest of the image's frame and size
};

/// Returns "exact", "latest" or "auto".
const char* nameOf(InfoMatching matching);

/// Returns the matching of this name; nothing if there is none.
std::optional<InfoMatching> infoMatchingOf(const std::string& name);

/// Pairs images with camera_infos, whichever of the two comes first.
///
/// The order of arrival counts, not that of the stamps: these may go back when a bag begins again. Images
/// that wait are bounded in number; the oldest gives way, and is counted. Not thread-safe.
class InfoMatcher {
 public:
  using TimePoint = InfoHistory::TimePoint;
  using Frames = std::vector<CameraFrame>;

  /// What makes kAuto fall back.
  enum class Patience {
    kSecond,  ///< a second without a pair, while images come
    kFull,    ///< as many images without a pair as may wait, or the end of the input: time does not count
  };

  /// @param waiting  images that wait at most; at least 1
  InfoMatcher(InfoMatching matching, std::size_t waiting, Patience patience = Patience::kSecond)
      : matching_(matching), capacity_(waiting), patience_(patience) {}

  /// Takes an image; appends the frames that become whole.
  /// @param infos  those of the image's camera
  void addImage(const DepthMessage& image, const InfoHistory& infos, TimePoint now, Frames& frames);

  /// Takes note of a camera_info that was just added to `infos`; appends the frames that become whole.
  void addInfo(const ros::Time& stamp, const InfoHistory& infos, Frames& frames);

  /// Pairs the images that wait with what is in `infos`, which is another topic's than before.
  void retry(const InfoHistory& infos, Frames& frames);

  /// Appends the images that have waited for long enough to fall back. For input that stops.
  void poll(const InfoHistory& infos, TimePoint now, Frames& frames);

  /// At the end of the input: appends what can be paired, counts the rest.
  void finish(const InfoHistory& infos, Frames& frames);

  /// Forgets the images that wait, without counting them.
  void clear();

  /// Returns whether kAuto has fallen back to the newest camera_info.
  bool hasFallenBack() const { return has_fallen_back_; }

  /// Number of images that were discarded without a camera_info.
  std::uint64_t lostImages() const { return lost_images_; }

  /// Number of lost images whose camera_info arrived later.
  std::uint64_t lateInfos() const { return late_infos_; }

 private:
  struct Waiting {
    DepthMessage message;
    std::uint64_t number;
  };

  struct Guessed {
    ros::Time stamp;
    std::uint64_t number;
  };

  bool isDue(TimePoint now) const;
  void lose(const Waiting& image);
  void fallBack(const InfoHistory& infos, Frames& frames);
  void pairWithNewest(const InfoHistory& infos, Frames& frames);
  void foundExact(std::uint64_t number);
  sensor_msgs::CameraInfoConstPtr newestFor(const sensor_msgs::Image& image, const InfoHistory& infos) const;

  InfoMatching matching_;
  std::size_t capacity_;
  Patience patience_;
  std::deque<Waiting> waiting_;
  std::deque<Guessed> guessed_;  // the last images that were paired with the newest
  std::uint64_t images_ = 0;
  std::uint64_t last_exact_ = 0;  // number of the last image that had its own camera_info
  std::optional<TimePoint> unpaired_since_;
  bool has_fallen_back_ = false;
  std::deque<ros::Time> lost_stamps_;  // of the images that were lost last
  std::uint64_t lost_images_ = 0;
  std::uint64_t late_infos_ = 0;
};

}  // namespace line_plane_segmentation
