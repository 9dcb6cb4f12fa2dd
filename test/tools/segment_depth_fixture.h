// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <boost/crc.hpp>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "temporary_folder.h"
#include "tool_process.h"

namespace line_plane_segmentation {

// A wall 2 m before the camera, 5000 units a metre, with a strip without depth.
inline cv::Mat wall() {
  cv::Mat depth(480, 640, CV_16UC1, cv::Scalar(10000));
  depth.colRange(600, 640).setTo(0);
  return depth;
}

// The same PNG with another size in its header, and the header's checksum as it has to be.
inline std::string withSize(std::string png, std::uint32_t width, std::uint32_t height) {
  constexpr std::size_t kHeader = 12;
  constexpr std::size_t kWidth = 16;
  constexpr std::size_t kChecksum = 29;
  for (std::size_t i = 0; i < 4; ++i) {
    png[kWidth + i] = static_cast<char>(width >> (24 - 8 * i));
    png[kWidth + 4 + i] = static_cast<char>(height >> (24 - 8 * i));
  }
  boost::crc_32_type checksum;
  checksum.process_bytes(png.data() + kHeader, kChecksum - kHeader);
  for (std::size_t i = 0; i < 4; ++i)
    png[kChecksum + i] = static_cast<char>(checksum.checksum() >> (24 - 8 * i));
  return png;
}

/// Runs segment_depth on images of a temporary folder.
class SegmentDepth : public testing::Test {
 protected:
  std::string writeImage(const std::string& name, const cv::Mat& image) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    cv::imwrite((folder_ / name).string(), image);
    return (folder_ / name).string();
  }

  std::string out() const { return (folder_ / "out").string(); }

  static ToolResult run(const std::vector<std::string>& arguments) {
    return runProcess(SEGMENT_DEPTH, arguments);
  }

  ToolResult segment(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"--camera", "525,525,319.5,239.5", "--depth-scale", "5000", "--out",
                                       out()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  void expectRefused(const ToolResult& result, const std::string& reason) const {
    expectRefusal(result, "segment_depth", reason);
    EXPECT_FALSE(std::filesystem::exists(out())) << "left something behind";
  }

  TemporaryFolder folder_;
};

}  // namespace line_plane_segmentation
