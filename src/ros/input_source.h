// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

#include "input_frame.h"

namespace line_plane_segmentation {

/// Names of the input topics: either image and camera_info, or cloud. Unused names are empty.
struct InputTopics {
  std::string image;
  std::string info;
  std::string cloud;
};

/// Times of the last received messages. A default-constructed time_point means never.
struct InputTimes {
  using TimePoint = std::chrono::steady_clock::time_point;
  TimePoint subscribed;  ///< start of the subscription; never if not subscribed
  TimePoint image;
  TimePoint info;
  TimePoint frame;  ///< last pair of image and camera_info, or last cloud

  bool has_fallen_back =
      false;  ///< images are paired with the newest camera_info instead of the one with their timestamp
};

/// Interface of a subscription that produces frames. All calls, and the handler, run on the node handle's
/// single-threaded queue or under the caller's lock.
class InputSource {
 public:
  /// Called with each frame; must not block.
  using Handler = std::function<void(InputFrame)>;

  virtual ~InputSource() = default;
  virtual void subscribe() = 0;
  virtual void unsubscribe() = 0;

  bool subscribed() const { return times_.subscribed != InputTimes::TimePoint{}; }
  const InputTopics& topics() const { return topics_; }
  const InputTimes& times() const { return times_; }

  /// Returns the number of images that were discarded without a camera_info of their timestamp.
  virtual std::uint64_t lostImages() const { return 0; }

  /// Returns the number of these images whose camera_info arrived later.
  virtual std::uint64_t lateInfos() const { return 0; }

 protected:
  InputTopics topics_;
  InputTimes times_;
};

}  // namespace line_plane_segmentation
