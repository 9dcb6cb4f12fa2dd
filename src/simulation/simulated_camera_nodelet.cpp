// SPDX-License-Identifier: BSD-3-Clause
#include <geometry_msgs/TransformStamped.h>
#include <image_transport/image_transport.h>
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <tf2_ros/transform_broadcaster.h>
#include <pluginlib/class_list_macros.hpp>

#include <boost/make_shared.hpp>
#include <cstdint>
#include <exception>
#include <memory>
#include <string>

#include "camera_info_message.h"
#include "simulated_camera.h"
#include "simulated_camera_messages.h"
#include "simulated_camera_parameters.h"

namespace line_plane_segmentation {

/// A simulated Kinect as a camera driver would show it: `depth/image_raw` (16UC1, millimetres) with
/// `depth/camera_info`, and on demand `depth/labels` (16UC1, the exact label of every pixel's plane). Its
/// pose goes to /tf, so that the vertical is known.
///
/// Time advances with every tick of the timer, with or without subscribers. Images are rendered only while
/// there are subscribers. Published messages are never modified.
class SimulatedCameraNodelet : public nodelet::Nodelet {
 private:
  // No exception may leave this function: nodelet would use memory after freeing it.
  void onInit() override {
    try {
      start();
    } catch (const std::exception& exception) {
      ROS_ERROR("[%s] does not start: %s", getName().c_str(), exception.what());
    }
  }

  void start() {
    ros::NodeHandle& nh = getNodeHandle();
    ros::NodeHandle& private_nh = getPrivateNodeHandle();
    parameters_ = readParameters(private_nh);
    camera_ = std::make_unique<simulation::SimulatedCamera>(parameters_.camera);
    if (parameters_.publish_tf) tf_broadcaster_ = std::make_unique<tf2_ros::TransformBroadcaster>();
    depth_publisher_ = image_transport::ImageTransport(nh).advertiseCamera("depth/image_raw", 1);
    labels_publisher_ = nh.advertise<sensor_msgs::Image>("depth/labels", 1);
    timer_ = private_nh.createWallTimer(ros::WallDuration(1.0 / parameters_.rate),
                                        [this](const ros::WallTimerEvent&) { tick(); });
  }

  void tick() {
    try {
      takeFrame();
    } catch (const std::exception& exception) {
      ROS_ERROR_THROTTLE(5.0, "[%s] no picture: %s", getName().c_str(), exception.what());
    }
    ++frame_;
  }

  void takeFrame() {
    std_msgs::Header header;
    header.stamp = ros::Time::now();
    header.frame_id = parameters_.frame_id;
    const double seconds = static_cast<double>(frame_) / parameters_.rate;
    // The pose is published before the image that needs it.
    if (tf_broadcaster_) {
      tf_broadcaster_->sendTransform(
          transformMessage(camera_->pose(seconds), header, parameters_.world_frame));
    }

    const bool depth_wanted = depth_publisher_.getNumSubscribers() > 0;
    const bool labels_wanted = labels_publisher_.getNumSubscribers() > 0;
    if (!depth_wanted && !labels_wanted) return;
    const auto image = imageMessage(header, parameters_.camera.width, parameters_.camera.height);
    const simulation::Rendering& truth = camera_->capture(frame_, seconds, pixelsOf(*image));
    if (depth_wanted) {
      depth_publisher_.publish(
          image, boost::make_shared<sensor_msgs::CameraInfo>(makeCameraInfo(
                     header, camera_->intrinsics(), parameters_.camera.width, parameters_.camera.height)));
    }
    if (labels_wanted) labels_publisher_.publish(labelsMessage(header, truth));
  }

  SimulatedCameraParameters parameters_;
  std::unique_ptr<simulation::SimulatedCamera> camera_;
  std::unique_ptr<tf2_ros::TransformBroadcaster> tf_broadcaster_;
  image_transport::CameraPublisher depth_publisher_;
  ros::Publisher labels_publisher_;
  std::uint64_t frame_ = 0;
  ros::WallTimer timer_;
};

}  // namespace line_plane_segmentation

PLUGINLIB_EXPORT_CLASS(line_plane_segmentation::SimulatedCameraNodelet, nodelet::Nodelet)
