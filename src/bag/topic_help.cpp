// SPDX-License-Identifier: BSD-3-Clause
#include "topic_help.h"

namespace line_plane_segmentation {
namespace {

constexpr std::size_t kMostTopics = 8;  // of a kind, in one line

std::string join(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < kMostTopics; ++i) text += (i == 0 ? "" : ", ") + names[i];
  if (names.size() > kMostTopics) text += " and " + std::to_string(names.size() - kMostTopics) + " more";
  return text;
}

bool isImage(const std::string& type) {
  return type == "sensor_msgs/Image" || type == "sensor_msgs/CompressedImage" ||
         type == "stereo_msgs/DisparityImage";
}

// Encoded as depth is, but not known to be depth.
bool mayBeDepth(const std::string& encoding) { return encoding == "mono16"; }

}  // namespace

std::string describeTopics(const std::map<std::string, std::string>& types, const DepthTopics& topics) {
  std::vector<std::string> images;
  std::vector<std::string> clouds;
  std::string candidate;
  for (const auto& [name, encoding] : topics.others()) {
    images.push_back(name + " (" + encoding + ")");
    if (mayBeDepth(encoding)) candidate = name;
  }
  for (const auto& [name, type] : types) {
    if (isImage(type) && topics.others().count(name) == 0) images.push_back(name + " (" + type + ")");
    if (type == "sensor_msgs/PointCloud2") clouds.push_back(name);
  }
  if (images.empty() && clouds.empty()) {
    return types.empty() ? "there are no images in what can be read" : "there are no images among its topics";
  }
  std::string text;
  if (!images.empty()) text = "its images are " + join(images);
  if (!candidate.empty()) text += "; if one of them is depth, name it: --topic " + candidate;
  if (!clouds.empty()) {
    text += (text.empty() ? "it has" : "; there are") + std::string(" point clouds, ") + join(clouds) +
            ": play them to the nodelet with cloud_topic:=" + clouds.front();
  }
  return text;
}

std::string describeInfoOptions(const std::vector<std::string>& infos) {
  const std::string camera = "give the intrinsics with --camera FX,FY,CX,CY";
  return infos.empty()
             ? "there is none: " + camera
             : "there is camera_info on " + join(infos) + ": name it with --info-topic, or " + camera;
}

}  // namespace line_plane_segmentation
