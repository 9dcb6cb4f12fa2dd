// SPDX-License-Identifier: BSD-3-Clause
#include "image_validation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "image_validation_cases.h"
#include "test_messages.h"

namespace line_plane_segmentation {
namespace {

using sensor_msgs::CameraInfo;
using sensor_msgs::Image;

class ValidationTable : public testing::TestWithParam<ValidationCase> {};

TEST_P(ValidationTable, decidesAsPromised) {
  Image image = testImage(32, 24, "16UC1");
  CameraInfo info = testInfo(32, 24);
  GetParam().spoil(image, info);

  const Validation found = validate(image, info);

  EXPECT_STREQ(nameOf(GetParam().expected), nameOf(found.refusal));
  EXPECT_EQ(GetParam().expected == Refusal::kNone, found.accepted());
  const std::string explanation = explain(found.refusal, image, info);
  EXPECT_EQ(found.accepted(), explanation.empty());
  EXPECT_LT(explanation.size(), 400U);
  if (found.accepted()) {
    EXPECT_EQ(image.data.data(), found.view.data) << "the view is not of the message's own bytes";
    EXPECT_EQ(static_cast<int>(image.width), found.view.width);
    EXPECT_EQ(static_cast<int>(image.height), found.view.height);
    EXPECT_EQ(image.step, found.view.step);
    EXPECT_TRUE(found.camera.isValid());
  } else {
    EXPECT_TRUE(found.view.empty());
  }
}

INSTANTIATE_TEST_SUITE_P(Faults, ValidationTable, testing::ValuesIn(validationCases()));

TEST(Validation, refusesByTheGivenLimit) {
  const Image image = testImage(32, 24, "16UC1");
  EXPECT_TRUE(validate(image, testInfo(32, 24), {32 * 24}).accepted());
  EXPECT_EQ(Refusal::kTooLarge, validate(image, testInfo(32, 24), {32 * 24 - 1}).refusal);
}

TEST(Validation, tellsHowPixelsAreStored) {
  const CameraInfo info = testInfo(32, 24);
  const DepthView millimetres = validate(testImage(32, 24, "mono16"), info).view;
  EXPECT_EQ(DepthType::kUint16, millimetres.type);
  EXPECT_FLOAT_EQ(0.001F, millimetres.depth_unit);
  const DepthView metres = validate(testImage(32, 24, "32FC1"), info).view;
  EXPECT_EQ(DepthType::kFloat32, metres.type);
  EXPECT_FLOAT_EQ(1.0F, metres.depth_unit);
}

// Row 8: the same depths for both byte orders.
TEST(Validation, readsBothByteOrders) {
  for (const char* encoding : {"16UC1", "32FC1"}) {
    Image native = imageOfPlane(32, 24, encoding, Eigen::Vector3d(0.0, 0.6, -0.8), 1.5);
    Image swapped = native;
    swapped.is_bigendian = native.is_bigendian == 0 ? 1 : 0;
    const std::size_t size = pixelSize(encoding);
    for (std::size_t i = 0; i < swapped.data.size(); i += size) {
      std::reverse(swapped.data.begin() + static_cast<std::ptrdiff_t>(i),
                   swapped.data.begin() + static_cast<std::ptrdiff_t>(i + size));
    }
    std::vector<float> expected(32);
    std::vector<float> read(32);
    loadRow(validate(native, testInfo(32, 24)).view, 11, {}, expected.data());
    loadRow(validate(swapped, testInfo(32, 24)).view, 11, {}, read.data());
    EXPECT_GT(expected[5], 0.5F);
    EXPECT_EQ(expected, read) << encoding;
  }
}

TEST(Validation, takesIntrinsicsFromPAndElseFromK) {
  const Image image = testImage(32, 24, "16UC1");
  CameraInfo info = testInfo(32, 24);
  info.P = {30.0, 0.0, 15.0, 0.0, 0.0, 31.0, 11.0, 0.0, 0.0, 0.0, 1.0, 0.0};
  const Validation from_p = validate(image, info);
  EXPECT_FALSE(from_p.intrinsics_from_k);
  EXPECT_EQ(30.0, from_p.camera.fx);
  EXPECT_EQ(31.0, from_p.camera.fy);
  EXPECT_EQ(15.0, from_p.camera.cx);
  EXPECT_EQ(11.0, from_p.camera.cy);

  info.P.fill(0.0);
  const Validation from_k = validate(image, info);
  EXPECT_TRUE(from_k.intrinsics_from_k);
  EXPECT_EQ(info.K[0], from_k.camera.fx);
  EXPECT_EQ(info.K[5], from_k.camera.cy);
}

// The sensor is 640x480; the image is its region of 320x240 from (100, 60), binned by 2.
TEST(Validation, movesAndScalesIntrinsicsWithTheImage) {
  CameraInfo info = testInfo(640, 480);
  info.P = {500.0, 0.0, 320.0, 0.0, 0.0, 510.0, 240.0, 0.0, 0.0, 0.0, 1.0, 0.0};
  info.roi.x_offset = 100;
  info.roi.y_offset = 60;
  info.roi.width = 320;
  info.roi.height = 240;
  info.binning_x = info.binning_y = 2;
  const Validation found = validate(testImage(160, 120, "16UC1"), info);
  ASSERT_TRUE(found.accepted());
  EXPECT_EQ(250.0, found.camera.fx);
  EXPECT_EQ(255.0, found.camera.fy);
  EXPECT_EQ(110.0, found.camera.cx);
  EXPECT_EQ(90.0, found.camera.cy);
}

// K describes the raw image, P the rectified one. A third of a pixel is no binary fraction.
TEST(Intrinsics, areOfTheRawOrTheRectifiedImage) {
  CameraInfo info = testInfo(640, 480);
  info.K = {501.0, 0.0, 321.0, 0.0, 511.0, 241.0, 0.0, 0.0, 1.0};
  info.P = {400.0, 0.0, 320.0, 0.0, 0.0, 410.0, 240.0, 0.0, 0.0, 0.0, 1.0, 0.0};
  info.binning_x = 3;
  info.roi.x_offset = 21;
  info.roi.y_offset = 11;  // without a height: the full height is shown
  info.roi.width = 300;
  const CameraIntrinsics raw = rawIntrinsics(info);
  EXPECT_DOUBLE_EQ(167.0, raw.fx);
  EXPECT_DOUBLE_EQ(511.0, raw.fy);
  EXPECT_DOUBLE_EQ(100.0, raw.cx);
  EXPECT_DOUBLE_EQ(241.0, raw.cy);
  const CameraIntrinsics rectified = rectifiedIntrinsics(info);
  EXPECT_DOUBLE_EQ(400.0 / 3.0, rectified.fx);
  EXPECT_DOUBLE_EQ(410.0, rectified.fy);
  EXPECT_DOUBLE_EQ(299.0 / 3.0, rectified.cx);
  EXPECT_DOUBLE_EQ(240.0, rectified.cy);
}

TEST(Validation, noticesDistortion) {
  CameraInfo info = testInfo(32, 24);
  EXPECT_FALSE(validate(testImage(32, 24, "16UC1"), info).distorted);
  info.D[4] = -0.3;
  EXPECT_TRUE(validate(testImage(32, 24, "16UC1"), info).distorted);
}

TEST(Explanation, namesTheEncodingButNotAllOfIt) {
  Image image = testImage(32, 24, "16UC1");
  image.encoding = "rgb8";
  EXPECT_NE(std::string::npos, explain(Refusal::kEncoding, image, testInfo(32, 24)).find("'rgb8'"));
  image.encoding = "bad\n\x07" + std::string(1000, 'x');
  const std::string explanation = explain(Refusal::kEncoding, image, testInfo(32, 24));
  EXPECT_NE(std::string::npos, explanation.find("'bad??xxx"));
  EXPECT_EQ(std::string::npos, explanation.find('\n'));
}

}  // namespace
}  // namespace line_plane_segmentation
