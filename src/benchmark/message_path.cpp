// SPDX-License-Identifier: BSD-3-Clause
#include "message_path.h"

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include <boost/make_shared.hpp>
#include <chrono>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace line_plane_segmentation {
namespace {

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;

constexpr double kPatience = 15.0;  // [s]

std_msgs::Header headerOf(std::uint32_t number) {
  std_msgs::Header header;
  header.frame_id = "camera_depth_optical_frame";
  header.stamp = ros::Time(number, 0);
  return header;
}

// In millimetres, as ROS has 16-bit depths.
sensor_msgs::ImagePtr imageOf(const BenchmarkFrame& frame, const std_msgs::Header& header) {
  auto image = boost::make_shared<sensor_msgs::Image>();
  image->header = header;
  image->encoding = "16UC1";
  image->width = static_cast<std::uint32_t>(frame.width);
  image->height = static_cast<std::uint32_t>(frame.height);
  image->step = static_cast<std::uint32_t>(image->width * sizeof(std::uint16_t));
  image->data.resize(std::size_t{image->step} * image->height);
  std::uint8_t* pixel = image->data.data();
  for (const std::uint16_t depth : frame.depth) {
    const auto millimetres = static_cast<std::uint16_t>(std::lround(1000.0F * frame.metres_per_unit * depth));
    std::memcpy(pixel, &millimetres, sizeof millimetres);
    pixel += sizeof millimetres;
  }
  return image;
}

sensor_msgs::CameraInfoPtr infoOf(const BenchmarkFrame& frame, const std_msgs::Header& header) {
  const CameraIntrinsics& camera = frame.camera;
  auto info = boost::make_shared<sensor_msgs::CameraInfo>();
  info->header = header;
  info->width = static_cast<std::uint32_t>(frame.width);
  info->height = static_cast<std::uint32_t>(frame.height);
  info->K = {camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0};
  info->P = {camera.fx, 0.0, camera.cx, 0.0, 0.0, camera.fy, camera.cy, 0.0, 0.0, 0.0, 1.0, 0.0};
  return info;
}

}  // namespace

MessagePath::MessagePath(nodelet::Loader& loader, const std::string& name_space,
                         const std::vector<std::string>& outputs)
    : nh_(name_space) {
  nh_.setCallbackQueue(&queue_);
  images_ = nh_.advertise<sensor_msgs::Image>("depth/image_rect", 1);
  infos_ = nh_.advertise<sensor_msgs::CameraInfo>("depth/camera_info", 1);
  const std::string segmenter = nh_.resolveName("plane_segmenter");
  if (!loader.load(segmenter, "line_plane_segmentation/plane_segmenter", {}, {})) {
    throw std::runtime_error("the nodelet cannot be loaded");
  }
  for (const std::string& output : outputs) {
    const std::string topic = segmenter + '/' + output;
    if (output == "planes") {
      subscribe<PlaneArray>(topic);
    } else if (output == "cloud") {
      subscribe<sensor_msgs::PointCloud2>(topic);
    } else if (output == "markers" || output == "scanlines") {
      subscribe<visualization_msgs::MarkerArray>(topic);
    } else {
      subscribe<sensor_msgs::Image>(topic);
    }
  }
}

// Markers have no stamp of their own: with one frame at a time, each output comes once for it.
template <typename Message>
void MessagePath::subscribe(const std::string& topic) {
  subscribers_.push_back(
      nh_.subscribe<Message>(topic, 1, [this](const boost::shared_ptr<const Message>& message) {
        ++answers_;
        take(*message);
      }));
}

void MessagePath::take(const PlaneArray& planes) {
  times_.planes = static_cast<int>(planes.planes.size());
  times_.segmenter = static_cast<double>(planes.processing_time);
}

bool MessagePath::publishAndWait(const BenchmarkFrame& frame, double seconds) {
  const std_msgs::Header header = headerOf(++number_);
  const sensor_msgs::ImagePtr image = imageOf(frame, header);
  answers_ = 0;
  infos_.publish(infoOf(frame, header));
  const Clock::time_point start = Clock::now();
  images_.publish(image);
  while (answers_ < subscribers_.size()) {
    queue_.callAvailable(ros::WallDuration(0.01));
    if (Clock::now() - start > std::chrono::duration<double>(seconds)) return false;
  }
  times_.answered = Milliseconds(Clock::now() - start).count();
  return true;
}

void MessagePath::connect(const BenchmarkFrame& frame) {
  const Clock::time_point start = Clock::now();
  while (!publishAndWait(frame, 0.3)) {
    if (Clock::now() - start > std::chrono::duration<double>(kPatience)) {
      throw std::runtime_error("the segmenter does not answer");
    }
  }
}

MessageTimes MessagePath::send(const BenchmarkFrame& frame) {
  if (!publishAndWait(frame, kPatience)) throw std::runtime_error(frame.name + ": was not answered");
  return times_;
}

}  // namespace line_plane_segmentation
