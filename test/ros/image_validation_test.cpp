// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/ros/image_validation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "test_messages.h"

namespace line_plane_segmentation {
namespace {

using sensor_msgs::CameraInfo;
using sensor_msgs::Image;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr std::uint32_t kMaxUint32 = std::numeric_limits<std::uint32_t>::max();

// One message that is good but for what `spoil` does to it.
struct Case {
  const char* what;
  Refusal expected;
  std::function<void(Image&, CameraInfo&)> spoil;
};

void PrintTo(const Case& c, std::ostream* stream) { *stream << c.what; }

void setFocalLengths(CameraInfo& info, double fx, double fy) {
  info.K[0] = info.P[0] = fx;
  info.K[4] = info.P[5] = fy;
}

const std::vector<Case>& table() {
  static const std::vector<Case> kTable = {
      {"as a camera sends it", Refusal::kNone, [](Image&, CameraInfo&) {}},

      {"row 1: width 0", Refusal::kEmptyImage, [](Image& i, CameraInfo&) { i.width = 0; }},
      {"row 1: height 0", Refusal::kEmptyImage, [](Image& i, CameraInfo&) { i.height = 0; }},
      {"row 1: a default message", Refusal::kEmptyImage,
       [](Image& i, CameraInfo& c) {
         i = Image();
         c = CameraInfo();
       }},

      {"row 2: no data", Refusal::kShortData, [](Image& i, CameraInfo&) { i.data.clear(); }},
      {"row 2: one byte short", Refusal::kShortData, [](Image& i, CameraInfo&) { i.data.pop_back(); }},
      {"row 2: longer than needed", Refusal::kNone,
       [](Image& i, CameraInfo&) { i.data.resize(i.data.size() + 7); }},

      {"row 3: step one byte short", Refusal::kBadStep, [](Image& i, CameraInfo&) { --i.step; }},
      {"row 3: step 0", Refusal::kBadStep, [](Image& i, CameraInfo&) { i.step = 0; }},
      {"row 3: step of 16 bits under 32FC1", Refusal::kBadStep,
       [](Image& i, CameraInfo&) { i.encoding = "32FC1"; }},

      {"row 4: height * step wraps to 0", Refusal::kTooLarge,
       [](Image& i, CameraInfo&) {
         i.width = 1;
         i.height = 65536;
         i.step = 65536;
         i.data.clear();
       }},
      {"row 4: width * height wraps to 0", Refusal::kTooLarge,
       [](Image& i, CameraInfo&) {
         i.width = i.height = 65536;
         i.step = 2 * 65536;
         i.data.clear();
       }},
      {"row 4: everything at its largest", Refusal::kTooLarge,
       [](Image& i, CameraInfo&) { i.width = i.height = i.step = kMaxUint32; }},
      {"row 4: more than max_pixels", Refusal::kTooLarge,
       [](Image& i, CameraInfo&) {
         i.width = 4097;
         i.height = 4096;
         i.step = 2 * 4097;
       }},
      {"row 4: 2 * width wraps to 0", Refusal::kTooLarge,
       [](Image& i, CameraInfo&) {
         i.width = 0x80000000U;
         i.height = 1;
         i.step = 0;
       }},

      {"row 5: padded rows", Refusal::kNone,
       [](Image& i, CameraInfo&) {
         i.step += 3;
         i.data.resize(std::size_t{i.step} * i.height);
       }},

      {"row 6: rgb8", Refusal::kEncoding, [](Image& i, CameraInfo&) { i.encoding = "rgb8"; }},
      {"row 6: 8UC1", Refusal::kEncoding, [](Image& i, CameraInfo&) { i.encoding = "8UC1"; }},
      {"row 6: 64FC1", Refusal::kEncoding, [](Image& i, CameraInfo&) { i.encoding = "64FC1"; }},
      {"row 6: no encoding", Refusal::kEncoding, [](Image& i, CameraInfo&) { i.encoding.clear(); }},
      {"row 6: garbage", Refusal::kEncoding,
       [](Image& i, CameraInfo&) { i.encoding.assign(100000, '\x01'); }},
      {"row 7: mono16", Refusal::kNone, [](Image& i, CameraInfo&) { i.encoding = "mono16"; }},
      {"row 8: big-endian", Refusal::kNone, [](Image& i, CameraInfo&) { i.is_bigendian = 1; }},

      {"row 15: K and P zero", Refusal::kNoIntrinsics,
       [](Image&, CameraInfo& c) {
         c.K.fill(0.0);
         c.P.fill(0.0);
       }},
      {"row 16: P zero", Refusal::kNone, [](Image&, CameraInfo& c) { c.P.fill(0.0); }},
      {"row 16: P zero but for its scale", Refusal::kNone,
       [](Image&, CameraInfo& c) {
         c.P.fill(0.0);
         c.P[10] = 1.0;
       }},
      {"row 17: fx NaN", Refusal::kNoIntrinsics,
       [](Image&, CameraInfo& c) { setFocalLengths(c, kNan, 525.0); }},
      {"row 17: fy NaN", Refusal::kNoIntrinsics,
       [](Image&, CameraInfo& c) { setFocalLengths(c, 525.0, kNan); }},
      {"row 17: fx infinite", Refusal::kNoIntrinsics,
       [](Image&, CameraInfo& c) { setFocalLengths(c, kInf, 525.0); }},
      {"row 17: fy -infinite", Refusal::kNoIntrinsics,
       [](Image&, CameraInfo& c) { setFocalLengths(c, 525.0, -kInf); }},
      {"row 17: fx 0", Refusal::kNoIntrinsics, [](Image&, CameraInfo& c) { setFocalLengths(c, 0.0, 525.0); }},
      {"row 17: fy negative", Refusal::kNoIntrinsics,
       [](Image&, CameraInfo& c) { setFocalLengths(c, 525.0, -525.0); }},
      {"row 17: fx so small that points are infinite", Refusal::kNoIntrinsics,
       [](Image&, CameraInfo& c) { setFocalLengths(c, 1e-310, 525.0); }},
      {"row 17: fy beyond all lenses", Refusal::kNoIntrinsics,
       [](Image&, CameraInfo& c) { setFocalLengths(c, 525.0, 1e300); }},
      {"row 17: cx NaN", Refusal::kNoIntrinsics, [](Image&, CameraInfo& c) { c.P[2] = kNan; }},
      {"row 17: cy infinite", Refusal::kNoIntrinsics, [](Image&, CameraInfo& c) { c.P[6] = kInf; }},
      {"row 17: axis outside the image", Refusal::kNone, [](Image&, CameraInfo& c) { c.P[2] = -40.0; }},

      {"row 18: info of another width", Refusal::kInfoMismatch, [](Image&, CameraInfo& c) { c.width *= 2; }},
      {"row 18: info of another height", Refusal::kInfoMismatch, [](Image&, CameraInfo& c) { --c.height; }},
      {"row 18: info without a size", Refusal::kInfoMismatch,
       [](Image&, CameraInfo& c) { c.width = c.height = 0; }},
      {"row 18: binned", Refusal::kNone,
       [](Image&, CameraInfo& c) {
         c.width *= 2;
         c.height *= 2;
         c.binning_x = c.binning_y = 2;
       }},
      {"row 18: binned, odd size rounded down", Refusal::kNone,
       [](Image&, CameraInfo& c) {
         c.width = 2 * c.width + 1;
         c.binning_x = 2;
       }},
      {"row 18: binned, odd size rounded up", Refusal::kNone,
       [](Image&, CameraInfo& c) {
         c.width = 2 * c.width - 1;
         c.binning_x = 2;
       }},
      {"row 18: binning that does not fit", Refusal::kInfoMismatch,
       [](Image&, CameraInfo& c) { c.binning_x = 2; }},
      {"row 18: binning at its largest", Refusal::kInfoMismatch,
       [](Image&, CameraInfo& c) { c.binning_x = c.binning_y = kMaxUint32; }},
      {"row 18: region of interest", Refusal::kNone,
       [](Image& i, CameraInfo& c) {
         c.roi.width = i.width;
         c.roi.height = i.height;
         c.roi.x_offset = 100;
         c.roi.y_offset = 50;
         c.width = 640;
         c.height = 480;
       }},
      {"row 18: region of interest of another size", Refusal::kInfoMismatch,
       [](Image&, CameraInfo& c) {
         c.roi.width = 5;
         c.roi.height = 5;
       }},

      {"row 19: distorted", Refusal::kNone, [](Image&, CameraInfo& c) { c.D[0] = 0.1; }},
      {"row 19: no distortion given", Refusal::kNone, [](Image&, CameraInfo& c) { c.D.clear(); }},
      {"row 25: no frame_id", Refusal::kNone, [](Image& i, CameraInfo&) { i.header.frame_id.clear(); }},
      {"row 25: frame_id with a slash", Refusal::kNone,
       [](Image& i, CameraInfo&) { i.header.frame_id = "/camera"; }},
  };
  return kTable;
}

class ValidationTable : public testing::TestWithParam<Case> {};

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

INSTANTIATE_TEST_SUITE_P(Faults, ValidationTable, testing::ValuesIn(table()));

TEST(Validation, refusesByTheGivenLimit) {
  const Image image = testImage(32, 24, "16UC1");
  EXPECT_TRUE(validate(image, testInfo(32, 24), {32 * 24}).accepted());
  EXPECT_EQ(Refusal::kTooLarge, validate(image, testInfo(32, 24), {32 * 24 - 1}).refusal);
}

TEST(Validation, tellsHowPixelsAreStored) {
  const CameraInfo info = testInfo(32, 24);
  const DepthView millimetres = validate(testImage(32, 24, "mono16"), info).view;
  EXPECT_EQ(DepthType::kUint16, millimetres.type);
  EXPECT_FLOAT_EQ(0.001F, millimetres.metres_per_unit);
  const DepthView metres = validate(testImage(32, 24, "32FC1"), info).view;
  EXPECT_EQ(DepthType::kFloat32, metres.type);
  EXPECT_FLOAT_EQ(1.0F, metres.metres_per_unit);
}

// Row 8: the same depths, whichever way round the bytes are.
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

// The full sensor is 640x480; the image shows 320x240 of it from (100, 60) on, two pixels in one.
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
