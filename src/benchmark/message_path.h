// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <line_plane_segmentation/PlaneArray.h>
#include <nodelet/loader.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>

#include <cstdint>
#include <string>
#include <vector>

#include "benchmark_frame.h"

namespace line_plane_segmentation {

/// Result and times of one frame.
struct MessageTimes {
  int planes = 0;
  double segmenter = 0.0;  ///< [ms] of the segmenter alone
  double answered = 0.0;   ///< [ms] from publishing the image until the last output has arrived
};

/// The segmenter nodelet in this process, a publisher of its images, and subscribers to its outputs. As in a
/// nodelet manager, no message is serialised.
class MessagePath {
 public:
  /// @param loader      of nodelets; must outlive this
  /// @param name_space  where the nodelet and its topics are
  /// @param outputs     of the nodelet to subscribe to, including `planes`
  MessagePath(nodelet::Loader& loader, const std::string& name_space,
              const std::vector<std::string>& outputs);
  MessagePath(const MessagePath&) = delete;
  MessagePath& operator=(const MessagePath&) = delete;

  /// Publishes the frame until every output has arrived once, so that all connections are established.
  /// @throws std::runtime_error if that takes too long
  void connect(const BenchmarkFrame& frame);

  /// Publishes the frame and waits for every output.
  /// @throws std::runtime_error if one does not arrive
  MessageTimes send(const BenchmarkFrame& frame);

 private:
  template <typename Message>
  void subscribe(const std::string& topic);
  bool publishAndWait(const BenchmarkFrame& frame, double seconds);
  void take(const PlaneArray& planes);
  template <typename Other>
  void take(const Other& /*message*/) {}

  ros::CallbackQueue queue_;
  ros::NodeHandle nh_;
  ros::Publisher images_, infos_;
  std::vector<ros::Subscriber> subscribers_;
  std::uint32_t number_ = 0;  // of the frame, its stamp
  std::size_t answers_ = 0;   // number of outputs of this frame that have arrived
  MessageTimes times_;
};

}  // namespace line_plane_segmentation
