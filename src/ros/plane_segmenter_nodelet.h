// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <dynamic_reconfigure/server.h>
#include <line_plane_segmentation/PlaneSegmenterConfig.h>
#include <nodelet/nodelet.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "frame_processor.h"
#include "input_source.h"
#include "outputs.h"
#include "parameter_config.h"
#include "transform_listener.h"

namespace line_plane_segmentation {

/// Segments the planes of a depth camera while at least one output has a subscriber.
///
/// Only the segmentation runs in its own thread (FrameProcessor). Pairing images with camera_info,
/// subscribing, reconfiguring and reporting run on the nodelet's single-threaded queue and take
/// microseconds.
class PlaneSegmenterNodelet : public nodelet::Nodelet {
 public:
  ~PlaneSegmenterNodelet() override;

 private:
  void onInit() override;
  void start();
  void stop();
  void reconfigure(PlaneSegmenterConfig& config);
  void logChanges(const std::vector<std::string>& changes);
  void updateSubscription();
  void reportStatus(diagnostic_updater::DiagnosticStatusWrapper& diagnostics);

  // Held while the members below are created, so that the callback of a subscriber that connects meanwhile
  // finds all of them.
  std::mutex connect_mutex_;
  std::string failure_;  // reason why the nodelet does not run; empty if it runs
  NodeletParameters parameters_;
  std::uint64_t reported_dropped_ = 0;
  std::uint64_t reported_lost_ = 0;
  std::uint64_t reported_late_ = 0;
  std::chrono::steady_clock::time_point changes_since_;
  std::size_t logged_changes_ = 0;  // since changes_since_

  // Order matters: each member uses the ones above it.
  std::unique_ptr<Outputs> outputs_;
  std::unique_ptr<TransformListener> transforms_;
  std::unique_ptr<FrameProcessor> processor_;
  std::unique_ptr<InputSource> subscription_;
  std::unique_ptr<dynamic_reconfigure::Server<PlaneSegmenterConfig>> reconfigure_server_;
  std::unique_ptr<diagnostic_updater::Updater> updater_;
  ros::WallTimer report_timer_;
};

}  // namespace line_plane_segmentation
