// SPDX-License-Identifier: BSD-3-Clause
#include "input_warnings.h"

#include <gtest/gtest.h>

#include "test_messages.h"

namespace line_plane_segmentation {
namespace {

const DepthRange kRange{0.3F, 10.0F};

OutOfRange fractionsOutOfRange(const sensor_msgs::Image& image) {
  return fractionsOutOfRange(validate(image, testInfo(image.width, image.height)).view, kRange);
}

double shareBeyondRange(const sensor_msgs::Image& image) { return fractionsOutOfRange(image).beyond; }

// Row 11.
TEST(FractionsOutOfRange, tellsMillimetresFromMetres) {
  sensor_msgs::Image metres = testImage(64, 48, "32FC1");
  sensor_msgs::Image millimetres = metres;
  for (std::uint32_t v = 0; v < 48; ++v) {
    for (std::uint32_t u = 0; u < 64; ++u) {
      setDepth(metres, u, v, 1.5);
      setDepth(millimetres, u, v, 1500.0);
    }
  }
  EXPECT_EQ(0.0, shareBeyondRange(metres));
  EXPECT_EQ(1.0, shareBeyondRange(millimetres));
}

TEST(FractionsOutOfRange, leavesMissingDepthOut) {
  sensor_msgs::Image image = testImage(64, 48, "32FC1");
  EXPECT_EQ(0.0, shareBeyondRange(image));
  setDepth(image, 3, 0, 2000.0);
  setDepth(image, 4, 0, std::nan(""));
  EXPECT_EQ(1.0, shareBeyondRange(image));
  setDepth(image, 5, 0, 2.0);
  EXPECT_EQ(0.5, shareBeyondRange(image));
}

TEST(FractionsOutOfRange, seesTheNearSide) {
  sensor_msgs::Image image = testImage(64, 48, "16UC1");
  for (std::uint32_t u = 0; u < 64; ++u) setDepth(image, u, 16, u < 16 ? 0.15 : 1.5);
  EXPECT_EQ(0.25, fractionsOutOfRange(image).near);
  EXPECT_EQ(0.0, fractionsOutOfRange(image).beyond);
}

}  // namespace
}  // namespace line_plane_segmentation
