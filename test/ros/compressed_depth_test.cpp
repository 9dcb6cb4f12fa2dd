// SPDX-License-Identifier: BSD-3-Clause
#include "compressed_depth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "compressed_depth_messages.h"

namespace line_plane_segmentation {
namespace {

constexpr int kWidth = 37;
constexpr int kHeight = 23;
constexpr std::uint64_t kAnySize = 1U << 24U;

// With runs of zeros, steps of all sizes, and depth in the last pixel.
std::vector<std::uint16_t> someDepth() {
  std::mt19937 random(7);
  std::vector<std::uint16_t> depth(kWidth * kHeight);
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const bool hole = (i / 11) % 3 == 0;
    depth[i] = hole ? 0 : static_cast<std::uint16_t>(i % 50 == 0 ? random() : 1500 + random() % 20);
  }
  depth.back() = 65535;
  return depth;
}

template <typename Number>
std::vector<Number> pixelsOf(const sensor_msgs::Image& image) {
  std::vector<Number> pixels(image.data.size() / sizeof(Number));
  std::memcpy(pixels.data(), image.data.data(), image.data.size());
  return pixels;
}

TEST(CompressedDepth, givesBackThePixels) {
  for (const char* format : {"16UC1; compressedDepth", "16UC1; compressedDepth png",
                             "16UC1; compressedDepth rvl", "mono16; compressedDepth png"}) {
    sensor_msgs::CompressedImage message = compressedDepth(someDepth(), kWidth, kHeight, format);
    message.header.frame_id = "camera";
    message.header.stamp = ros::Time(7.5);
    const auto described = describeCompressedDepth(message);
    ASSERT_TRUE(described) << format;
    sensor_msgs::Image image;
    ASSERT_TRUE(decodeCompressedDepth(message, kAnySize, image)) << format;
    for (const sensor_msgs::Image* each : {static_cast<const sensor_msgs::Image*>(described.get()),
                                           static_cast<const sensor_msgs::Image*>(&image)}) {
      EXPECT_EQ("camera", each->header.frame_id);
      EXPECT_EQ(ros::Time(7.5), each->header.stamp);
      EXPECT_EQ(std::string(format).substr(0, each->encoding.size()), each->encoding);
      EXPECT_EQ(kWidth, static_cast<int>(each->width));
      EXPECT_EQ(kHeight, static_cast<int>(each->height));
      EXPECT_EQ(2 * kWidth, static_cast<int>(each->step));
    }
    EXPECT_EQ(someDepth(), pixelsOf<std::uint16_t>(image)) << format;
  }
}

TEST(CompressedDepth, undoesTheQuantisationOfFloats) {
  constexpr float kA = 1000.0F;
  constexpr float kB = -3.0F;
  std::vector<std::uint16_t> numbers(kWidth * kHeight, 97);
  numbers[5] = 0;
  for (const char* format : {"32FC1; compressedDepth png", "32FC1; compressedDepth rvl"}) {
    sensor_msgs::Image image;
    ASSERT_TRUE(
        decodeCompressedDepth(compressedDepth(numbers, kWidth, kHeight, format, kA, kB), kAnySize, image));
    EXPECT_EQ("32FC1", image.encoding);
    EXPECT_EQ(4 * kWidth, static_cast<int>(image.step));
    const std::vector<float> metres = pixelsOf<float>(image);
    ASSERT_EQ(numbers.size(), metres.size());
    EXPECT_FLOAT_EQ(10.0F, metres[0]);
    EXPECT_TRUE(std::isnan(metres[5]));
  }
}

// The plain `compressed` plugin keeps 16 bits in PNG, too.
TEST(CompressedDepth, readsPlainPng) {
  sensor_msgs::CompressedImage message =
      compressedDepth(someDepth(), kWidth, kHeight, "16UC1; png compressed ");
  message.data.erase(message.data.begin(), message.data.begin() + 12);
  sensor_msgs::Image image;
  ASSERT_TRUE(decodeCompressedDepth(message, kAnySize, image));
  EXPECT_EQ(someDepth(), pixelsOf<std::uint16_t>(image));
}

TEST(CompressedDepth, refusesWhatIsNotDepth) {
  for (const char* format : {"rgb8; compressedDepth png", "", "jpeg", "32FC1; png compressed "}) {
    EXPECT_FALSE(describeCompressedDepth(compressedDepth(someDepth(), kWidth, kHeight, format))) << format;
  }
  sensor_msgs::CompressedImage jpeg;
  jpeg.format = "16UC1; jpeg compressed ";
  jpeg.data.assign(500, 0xFF);
  EXPECT_FALSE(describeCompressedDepth(jpeg));
}

// A size that is claimed takes no memory.
TEST(CompressedDepth, refusesTooManyPixels) {
  sensor_msgs::Image image;
  for (const char* format : {"16UC1; compressedDepth png", "16UC1; compressedDepth rvl"}) {
    sensor_msgs::CompressedImage message = compressedDepth(someDepth(), kWidth, kHeight, format);
    EXPECT_FALSE(decodeCompressedDepth(message, kWidth * kHeight - 1, image)) << format;
    const std::size_t size_at = message.format.find("rvl") != std::string::npos ? 12 : 12 + 16;
    for (std::size_t i = size_at; i < size_at + 8; ++i) message.data[i] = 0x40;
    EXPECT_FALSE(decodeCompressedDepth(message, kAnySize, image)) << format;
  }
}

TEST(CompressedDepth, survivesAnyBytes) {
  std::mt19937 random(3);
  sensor_msgs::Image image;
  for (const char* format :
       {"16UC1; compressedDepth png", "16UC1; compressedDepth rvl", "32FC1; compressedDepth rvl"}) {
    const sensor_msgs::CompressedImage whole = compressedDepth(someDepth(), kWidth, kHeight, format);
    for (std::size_t size = 0; size < whole.data.size(); size += 7) {
      sensor_msgs::CompressedImage cut = whole;
      cut.data.resize(size);
      EXPECT_FALSE(decodeCompressedDepth(cut, kAnySize, image)) << format << ", " << size;
    }
    for (int i = 0; i < 300; ++i) {
      sensor_msgs::CompressedImage changed = whole;
      changed.data[random() % changed.data.size()] = static_cast<std::uint8_t>(random());
      decodeCompressedDepth(changed, kAnySize, image);
    }
  }
}

TEST(CompressedDepth, knowsTheTopic) {
  EXPECT_EQ("/depth/image_raw", rawTopicOf("/depth/image_raw/compressedDepth"));
  EXPECT_EQ("/depth/image_raw", rawTopicOf("/depth/image_raw/compressed"));
  EXPECT_EQ("", rawTopicOf("/depth/image_raw"));
  EXPECT_EQ("", rawTopicOf("/compressed"));
}

}  // namespace
}  // namespace line_plane_segmentation
