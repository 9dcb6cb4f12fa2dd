// SPDX-License-Identifier: BSD-3-Clause
#include "plane_segmenter_nodelet.h"

#include <ros/console.h>

#include <chrono>
#include <exception>
#include <utility>
#include <vector>

#include "camera_subscription.h"
#include "cloud_subscription.h"
#include "log_exceptions.h"
#include "start_parameters.h"
#include "status_report.h"

namespace line_plane_segmentation {
namespace {

std::string describe(const InputTopics& topics) {
  return topics.cloud.empty() ? topics.image + " and " + topics.info : topics.cloud;
}

}  // namespace

PlaneSegmenterNodelet::~PlaneSegmenterNodelet() = default;

// No exception may leave onInit(): nodelet 1.10 would then use the deleted object.
void PlaneSegmenterNodelet::onInit() {
  try {
    const std::lock_guard<std::mutex> lock(connect_mutex_);
    try {
      start();
      ROS_INFO("[%s] idle until somebody subscribes to one of its outputs, then reads %s", getName().c_str(),
               describe(subscription_->topics()).c_str());
    } catch (const std::exception& exception) {
      stop();
      failure_ = exception.what();
      ROS_ERROR("[%s] does not start: %s", getName().c_str(), failure_.c_str());
    }
    removeInvalidDiagnosticPeriod(getPrivateNodeHandle());
    updater_ =
        std::make_unique<diagnostic_updater::Updater>(getNodeHandle(), getPrivateNodeHandle(), getName());
    updater_->setHardwareID("none");
    updater_->add("plane segmentation", this, &PlaneSegmenterNodelet::reportStatus);
    // Updater::update() stops reporting when simulated time jumps back.
    report_timer_ =
        getNodeHandle().createWallTimer(ros::WallDuration(1.0), [this](const ros::WallTimerEvent&) {
          logExceptions(getName(), [this] { updater_->force_update(); });
        });
  } catch (const std::exception& exception) {
    ROS_ERROR("[%s] does not start: %s", getName().c_str(), exception.what());
  }
  logExceptions(getName(), [this] { updateSubscription(); });
}

void PlaneSegmenterNodelet::start() {
  ros::NodeHandle& nh = getNodeHandle();
  ros::NodeHandle& private_nh = getPrivateNodeHandle();
  checkParameterServer(private_nh);
  parameters_.preset = expandPreset(private_nh);
  const StartParameters start = readStartParameters(private_nh);

  outputs_ = std::make_unique<Outputs>(private_nh, static_cast<unsigned>(start.queue_size), [this] {
    logExceptions(getName(), [this] { updateSubscription(); });
  });
  transforms_ = std::make_unique<TransformListener>(nh);
  processor_ = std::make_unique<FrameProcessor>(
      getName(), start.limits, static_cast<std::size_t>(start.queue_size), *outputs_, *transforms_);
  const InputSource::Handler push = [this](InputFrame frame) {
    processor_->mailbox().push(std::move(frame));
  };
  if (start.clouds) {
    subscription_ = std::make_unique<CloudSubscription>(nh, start.queue_size, push);
  } else {
    subscription_ = std::make_unique<CameraSubscription>(getName(), nh, private_nh, start, push);
  }
  reconfigure_server_ = std::make_unique<dynamic_reconfigure::Server<PlaneSegmenterConfig>>(private_nh);
  reconfigure_server_->setCallback([this](PlaneSegmenterConfig& config, std::uint32_t) {
    logExceptions(getName(), [&] { reconfigure(config); });
  });
}

void PlaneSegmenterNodelet::stop() {
  reconfigure_server_.reset();
  subscription_.reset();
  processor_.reset();
  transforms_.reset();
  outputs_.reset();
}

void PlaneSegmenterNodelet::reconfigure(PlaneSegmenterConfig& config) {
  std::vector<std::string> changes;
  parameters_ = reconfigured(parameters_, config, changes);
  logChanges(changes);
  processor_->setParameters(parameters_);
  transforms_->setNeeded(parameters_.location.frames.any());
}

// A program that goes on asking for what is refused does not fill the log.
void PlaneSegmenterNodelet::logChanges(const std::vector<std::string>& changes) {
  constexpr std::chrono::seconds kSpan(5);
  constexpr std::size_t kMostLines = 10;
  const std::chrono::steady_clock::time_point now = std::chrono::steady_clock::now();
  if (now - changes_since_ >= kSpan) {
    if (logged_changes_ > kMostLines) {
      ROS_WARN("[%s] %zu more settings were refused or changed", getName().c_str(),
               logged_changes_ - kMostLines);
    }
    changes_since_ = now;
    logged_changes_ = 0;
  }
  for (const std::string& change : changes) {
    if (++logged_changes_ <= kMostLines) ROS_WARN("[%s] %s", getName().c_str(), change.c_str());
  }
}

void PlaneSegmenterNodelet::updateSubscription() {
  const std::lock_guard<std::mutex> lock(connect_mutex_);
  if (!subscription_ || outputs_->subscribed() == subscription_->subscribed()) return;
  if (subscription_->subscribed()) {
    subscription_->unsubscribe();
    processor_->mailbox().clear();
    return;
  }
  try {
    subscription_->subscribe();
    failure_.clear();
  } catch (const std::exception& exception) {
    // The most likely cause is an image transport that is not installed.
    subscription_->unsubscribe();
    failure_ = exception.what();
    ROS_ERROR("[%s] cannot subscribe: %s", getName().c_str(), failure_.c_str());
  }
}

void PlaneSegmenterNodelet::reportStatus(diagnostic_updater::DiagnosticStatusWrapper& diagnostics) {
  const std::lock_guard<std::mutex> lock(connect_mutex_);
  NodeletStatus status;
  status.failure = failure_;
  if (subscription_) {
    status.subscribed = outputs_->subscribed();
    status.topics = subscription_->topics();
    status.input = subscription_->times();
    status.dropped = processor_->mailbox().dropped();
    status.newly_dropped = status.dropped - std::exchange(reported_dropped_, status.dropped);
    status.lost = subscription_->lostImages();
    status.newly_lost = status.lost - std::exchange(reported_lost_, status.lost);
    const std::uint64_t late = subscription_->lateInfos();
    status.newly_late = late - std::exchange(reported_late_, late);
    status.time_in_frame = processor_->processingTime().elapsed();
    status.frames = processor_->statistics().take();
    // Set here as well, since the updater's own value takes effect one report later.
    if (!status.frames.frame_id.empty()) diagnostics.hardware_id = status.frames.frame_id;
  }
  report(status, std::chrono::steady_clock::now(), diagnostics);
}

}  // namespace line_plane_segmentation
