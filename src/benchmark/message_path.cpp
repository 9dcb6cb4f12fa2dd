// SPDX-License-Identifier: BSD-3-Clause
#include "message_path.h"

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/image_encodings.h>
#include <visualization_msgs/MarkerArray.h>

#include <boost/make_shared.hpp>
#include <chrono>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "camera_info_message.h"
#include "image_message.h"

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
  const sensor_msgs::ImagePtr image = makeImage(header, sensor_msgs::image_encodings::TYPE_16UC1, frame.width,
                                                frame.height, sizeof(std::uint16_t));
  std::uint8_t* pixel = image->data.data();
  for (const std::uint16_t depth : frame.depth) {
    const auto millimetres = static_cast<std::uint16_t>(std::lround(1000.0F * frame.depth_unit * depth));
    std::memcpy(pixel, &millimetres, sizeof millimetres);
    pixel += sizeof millimetres;
  }
  return image;
}

template <typename Message>
const ros::Time& stampOf(const Message& message) {
  return message.header.stamp;
}

// The first marker, which takes those of the frame before away, has it.
const ros::Time& stampOf(const visualization_msgs::MarkerArray& markers) {
  return markers.markers.at(0).header.stamp;
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

// An output that arrives after the next frame was sent does not count for that frame.
template <typename Message>
void MessagePath::subscribe(const std::string& topic) {
  subscribers_.push_back(
      nh_.subscribe<Message>(topic, 1, [this](const boost::shared_ptr<const Message>& message) {
        if (stampOf(*message) != ros::Time(number_, 0)) return;
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
  infos_.publish(boost::make_shared<sensor_msgs::CameraInfo>(
      makeCameraInfo(header, frame.camera, frame.width, frame.height)));
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
  // Longer and longer, so that a slow machine's answer is in time, too.
  for (double seconds = 0.3; !publishAndWait(frame, seconds); seconds *= 2.0) {
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
