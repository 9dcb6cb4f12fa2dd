// SPDX-License-Identifier: BSD-3-Clause
#include "seeds.h"

#include <algorithm>
#include <cctype>
#include <cstddef>

#include "message_fields.h"
#include "ros/cloud_validation_cases.h"
#include "ros/image_validation_cases.h"
#include "ros/test_clouds.h"
#include "ros/test_messages.h"
#include "support/random.h"

namespace line_plane_segmentation {
namespace {

// Large enough for all that the tables do to it.
constexpr std::uint32_t kWidth = 12;
constexpr std::uint32_t kHeight = 9;
constexpr std::uint8_t kAsBytes = 0;  // the first byte: a message follows

template <typename... Messages>
std::vector<std::uint8_t> bytesOf(Messages&... messages) {
  std::vector<std::uint8_t> bytes = writeFields(messages...);
  bytes.insert(bytes.begin(), kAsBytes);
  return bytes;
}

Seeds frameSeeds() {
  Seeds seeds;
  for (const ValidationCase& each : validationCases()) {
    sensor_msgs::Image image = imageOfPlane(kWidth, kHeight, "16UC1", Eigen::Vector3d(0.0, 0.6, -0.8), 1.5);
    sensor_msgs::CameraInfo info = testInfo(kWidth, kHeight);
    each.spoil(image, info);
    seeds[seedNameOf(each.what)] = bytesOf(image, info);
  }
  return seeds;
}

Seeds cloudSeeds() {
  Seeds seeds;
  for (const CloudCase& each : cloudCases()) {
    sensor_msgs::PointCloud2 cloud = testCloud(kWidth, kHeight);
    setPlane(cloud, testCamera(kWidth, kHeight), Eigen::Vector3d(0.0, 0.6, -0.8), 1.5);
    each.spoil(cloud);
    seeds[seedNameOf(each.what)] = bytesOf(cloud);
  }
  return seeds;
}

// Any bytes: of a scene and the changes to it, or of parameters.
void addRandom(std::uint8_t first, Seeds& seeds) {
  for (int i = 0; i < 24; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    std::vector<std::uint8_t> bytes{first};
    for (int j = 0; j < 160; ++j) bytes.push_back(static_cast<std::uint8_t>(random.integer(0, 255)));
    seeds["random_" + std::to_string(first) + "_" + std::to_string(i)] = bytes;
  }
}

}  // namespace

std::string seedNameOf(std::string row) {
  std::replace_if(
      row.begin(), row.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return row;
}

std::map<std::string, Seeds> seeds() {
  constexpr std::uint8_t kDrawn = 255;
  std::map<std::string, Seeds> all;
  all["frame"] = frameSeeds();
  addRandom(kDrawn, all["frame"]);
  all["cloud"] = cloudSeeds();
  addRandom(kDrawn, all["cloud"]);
  for (std::uint8_t way = 0; way < 3; ++way) addRandom(way, all["parameters"]);
  return all;
}

}  // namespace line_plane_segmentation
