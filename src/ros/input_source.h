// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

#include "camera_frame.h"

namespace line_plane_segmentation {

/// The topics that frames come from: an image with its camera_info, or a cloud alone. The others are empty.
struct InputTopics {
  std::string image;
  std::string info;
  std::string cloud;
};

/// When something last came over a subscription. The default time_point: never.
struct InputTimes {
  using TimePoint = std::chrono::steady_clock::time_point;
  TimePoint subscribed;  ///< since when there is a subscription; never = there is none
  TimePoint image;
  TimePoint info;
  TimePoint frame;  ///< an image together with its camera_info, or a cloud

  bool has_fallen_back = false;  ///< images go with the newest camera_info, not with that of their stamp
};

/// A subscription that makes frames. All calls, and the handler, run on the node handle's (single-threaded)
/// queue or under the lock of whoever calls.
class InputSource {
 public:
  /// Called with every frame; must return at once.
  using Handler = std::function<void(CameraFrame)>;

  virtual ~InputSource() = default;
  virtual void subscribe() = 0;
  virtual void unsubscribe() = 0;

  bool subscribed() const { return times_.subscribed != InputTimes::TimePoint{}; }
  const InputTopics& topics() const { return topics_; }
  const InputTimes& times() const { return times_; }

  /// Number of images that were discarded without a camera_info of their stamp.
  virtual std::uint64_t lostImages() const { return 0; }

  /// Number of them whose camera_info arrived later.
  virtual std::uint64_t lateInfos() const { return 0; }

 protected:
  InputTopics topics_;
  InputTimes times_;
};

}  // namespace line_plane_segmentation
