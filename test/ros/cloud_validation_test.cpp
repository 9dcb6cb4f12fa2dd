// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_validation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/make_shared.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "cloud_validation_cases.h"
#include "frame_segmenter.h"
#include "test_clouds.h"

namespace line_plane_segmentation {
namespace {

constexpr std::uint32_t kWidth = 64;
constexpr std::uint32_t kHeight = 48;
const CameraIntrinsics kCamera{70.0, 75.0, 30.0, 25.5};
const Eigen::Vector3d kNormal = Eigen::Vector3d(0.2, -0.4, -1.0).normalized();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

class CloudValidation : public testing::Test {
 protected:
  CloudValidation() { setPlane(cloud_, kCamera, kNormal, 1.4); }

  Validation validate() { return line_plane_segmentation::validate(cloud_, limits_, depth_); }

  // Applies the function to every point.
  void change(
      const std::function<Eigen::Vector3d(std::uint32_t, std::uint32_t, const Eigen::Vector3d&)>& changed) {
    for (std::uint32_t v = 0; v < kHeight; ++v) {
      for (std::uint32_t u = 0; u < kWidth; ++u) {
        const Eigen::Vector3d ray = rayOf(kCamera, u, v);
        setPoint(cloud_, u, v, changed(u, v, -1.4 / kNormal.dot(ray) * ray));
      }
    }
  }

  void expectTheCamera(const CameraIntrinsics& camera, double tolerance = 1e-3) {
    EXPECT_NEAR(kCamera.fx, camera.fx, tolerance);
    EXPECT_NEAR(kCamera.fy, camera.fy, tolerance);
    EXPECT_NEAR(kCamera.cx, camera.cx, tolerance);
    EXPECT_NEAR(kCamera.cy, camera.cy, tolerance);
  }

  sensor_msgs::PointCloud2 cloud_ = testCloud(kWidth, kHeight);
  InputLimits limits_;
  std::vector<std::uint8_t> depth_;
};

TEST_F(CloudValidation, findsDepthAndCamera) {
  for (const bool big_endian : {false, true}) {
    SCOPED_TRACE(big_endian);
    cloud_.is_bigendian = big_endian;
    setPlane(cloud_, kCamera, kNormal, 1.4);
    const Validation found = validate();
    ASSERT_TRUE(found.accepted()) << nameOf(found.refusal);
    EXPECT_FALSE(found.distorted);
    expectTheCamera(found.camera);
    ASSERT_EQ(static_cast<int>(kWidth), found.view.width);
    ASSERT_EQ(static_cast<int>(kHeight), found.view.height);
    std::vector<float> row(kWidth);
    for (int v = 0; v < static_cast<int>(kHeight); ++v) {
      loadRow(found.view, v, {0.1F, 10.0F}, row.data());
      for (int u = 0; u < static_cast<int>(kWidth); ++u) {
        const Eigen::Vector3d ray = rayOf(kCamera, u, v);
        ASSERT_NEAR(-1.4 / kNormal.dot(ray), row[static_cast<std::size_t>(u)], 1e-5) << u << ' ' << v;
      }
    }
  }
}

class CloudTable : public testing::TestWithParam<CloudCase> {};

TEST_P(CloudTable, decidesAsPromised) {
  sensor_msgs::PointCloud2 cloud = testCloud(kWidth, kHeight);
  setPlane(cloud, kCamera, kNormal, 1.4);
  GetParam().spoil(cloud);

  std::vector<std::uint8_t> depth;
  const Validation found = validate(cloud, InputLimits{}, depth);

  EXPECT_STREQ(nameOf(GetParam().expected), nameOf(found.refusal));
  EXPECT_EQ(found.accepted(), explain(found.refusal, cloud).empty());
  EXPECT_EQ(!found.accepted(), found.view.empty());
}

INSTANTIATE_TEST_SUITE_P(Faults, CloudTable, testing::ValuesIn(cloudCases()));

TEST_F(CloudValidation, refusesByTheGivenLimit) {
  limits_.max_pixels = kWidth * kHeight;
  EXPECT_TRUE(validate().accepted());
  limits_.max_pixels = kWidth * kHeight - 1;
  const Validation found = validate();
  EXPECT_EQ(Refusal::kTooLarge, found.refusal) << nameOf(found.refusal);
  EXPECT_TRUE(found.view.empty());
  EXPECT_FALSE(explain(found.refusal, cloud_).empty());
}

TEST_F(CloudValidation, saysWhatIsWrongWithAnUnorganizedCloud) {
  EXPECT_NE(std::string::npos, explain(Refusal::kUnorganized, cloud_).find("unorganized"));
}

TEST_F(CloudValidation, missingAndAbsurdPointsDoNotCount) {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Eigen::Vector3d> holes = {
      {kNan, kNan, kNan}, {0.0, 0.0, 0.0},   {1.0, 1.0, 0.0},   {1.0, kNan, 1.0},      {1.0, 1.0, infinity},
      {infinity, 0, 1.0}, {0.0, 0.0, 1e-40}, {1.0, 1.0, 1e-38}, {1.0, 1.0, -infinity}, {3e38, 3e38, 1e-38}};
  change([&](std::uint32_t u, std::uint32_t v, const Eigen::Vector3d& point) {
    return (u + v) % 2 == 0 ? holes[(u * 7 + v) % holes.size()] : point;
  });
  const Validation found = validate();
  ASSERT_TRUE(found.accepted()) << nameOf(found.refusal);
  expectTheCamera(found.camera);
}

// They contain no plane, but they are valid.
TEST_F(CloudValidation, takesCloudsWithoutPoints) {
  change(
      [](std::uint32_t, std::uint32_t, const Eigen::Vector3d&) { return Eigen::Vector3d(kNan, kNan, kNan); });
  Validation found = validate();
  ASSERT_TRUE(found.accepted());
  EXPECT_TRUE(isUsable(found.camera));
  change([](std::uint32_t u, std::uint32_t, const Eigen::Vector3d& p) {
    return u == 5 ? p : Eigen::Vector3d(kNan, kNan, kNan);
  });
  found = validate();
  ASSERT_TRUE(found.accepted());
  EXPECT_TRUE(isUsable(found.camera));
}

TEST_F(CloudValidation, refusesCloudsThatNoPinholeCameraSees) {
  const std::vector<Eigen::Vector3d (*)(const Eigen::Vector3d&)> transforms = {
      [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p.z(), -p.x(), -p.y()); },  // x ahead, z up
      [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p.x(), p.y(), -p.z()); },   // behind
      [](const Eigen::Vector3d& p) { return Eigen::Vector3d(-p.x(), p.y(), p.z()); },   // mirrored
      [](const Eigen::Vector3d& p) { return Eigen::Vector3d(-p.y(), p.x(), p.z()); },   // turned about z
      [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p.x(), p.y(), 1.0 + p.z()); },
      [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p.x(), p.y(), 0.5 * p.z() + 0.2 * p.y()); }};
  for (std::size_t i = 0; i < transforms.size(); ++i) {
    // A near object in front of a far one: with equal depths, some of these clouds would match another
    // pinhole camera.
    change([&](std::uint32_t u, std::uint32_t v, const Eigen::Vector3d& p) {
      return transforms[i]((u / 8 + v / 8) % 2 == 0 ? p : (2.0 * p).eval());
    });
    EXPECT_EQ(Refusal::kNotPinhole, validate().refusal) << i;
  }
  EXPECT_FALSE(explain(Refusal::kNotPinhole, cloud_).empty());
}

TEST_F(CloudValidation, aLittleDistortionIsSaidAndMuchIsRefused) {
  const auto distort = [this](double factor) {
    change([factor](std::uint32_t, std::uint32_t, const Eigen::Vector3d& p) {
      const double scale = 1.0 + factor * p.head<2>().squaredNorm() / (p.z() * p.z());
      return Eigen::Vector3d(p.x() * scale, p.y() * scale, p.z());
    });
  };
  distort(0.5);
  const Validation found = validate();
  EXPECT_TRUE(found.accepted()) << nameOf(found.refusal);
  EXPECT_TRUE(found.distorted);
  distort(3.0);
  EXPECT_EQ(Refusal::kNotPinhole, validate().refusal);
}

// The cloud that the segmenter publishes leads to the same planes as the image that it comes from.
TEST(CloudFrame, isSegmentedAsItsImageIs) {
  sensor_msgs::Image image = imageOfPlane(320, 240, "32FC1", kNormal, 1.4);
  const sensor_msgs::Image wall = imageOfPlane(320, 240, "32FC1", Eigen::Vector3d(0.0, 0.0, -1.0), 1.8);
  std::copy_n(wall.data.begin(), wall.data.size() / 3, image.data.begin());
  setDepth(image, 100, 100, kNan);
  InputFrame of_image;
  of_image.image = boost::make_shared<sensor_msgs::Image>(image);
  of_image.info = boost::make_shared<sensor_msgs::CameraInfo>(testInfo(320, 240));
  FrameSegmenter segmenter;
  ASSERT_TRUE(segmenter.segment(of_image).accepted());
  PublishedPlanes published;
  published.header = segmenter.header();
  InputFrame of_cloud;
  of_cloud.cloud = coloredCloud(segmenter.result(published));

  FrameSegmenter other;
  ASSERT_TRUE(other.segment(of_cloud).accepted()) << other.explanation(of_cloud);
  EXPECT_EQ(kCameraFrame, other.header().frame_id);
  EXPECT_EQ(2U, other.segmentation().planes.size());
  EXPECT_EQ(segmenter.segmentation().labels, other.segmentation().labels);
  EXPECT_EQ(segmenter.segmentation().valid_pixels, other.segmentation().valid_pixels);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(segmenter.segmentation().planes.at(k).d, other.segmentation().planes.at(k).d, 1e-4);
  }
}

// The layout of points as drivers have it: the coordinates' order, what stands between them, and the byte
// order.
TEST(CloudLayout, takesWhatDriversSend) {
  struct Layout {
    const char* what;
    std::uint32_t x, y, z, point_step, row_padding;
    bool is_bigendian;
  };
  const Layout kLayouts[] = {
      {"packed", 0, 4, 8, 12, 0, false},        {"with colour", 0, 4, 8, 16, 0, false},
      {"as PCL has it", 0, 4, 8, 32, 0, false}, {"colour first", 4, 8, 12, 16, 0, false},
      {"backwards", 8, 4, 0, 12, 0, false},     {"padded rows", 0, 4, 8, 16, 48, false},
      {"big-endian", 0, 4, 8, 16, 0, true},     {"big-endian, backwards, padded", 9, 5, 1, 15, 7, true}};
  for (const Layout& layout : kLayouts) {
    SCOPED_TRACE(layout.what);
    sensor_msgs::PointCloud2 cloud = testCloud(32, 24);
    cloud.fields[0].offset = layout.x;
    cloud.fields[1].offset = layout.y;
    cloud.fields[2].offset = layout.z;
    cloud.point_step = layout.point_step;
    cloud.row_step = cloud.width * cloud.point_step + layout.row_padding;
    cloud.is_bigendian = layout.is_bigendian ? 1 : 0;
    cloud.data.assign(std::size_t{cloud.row_step} * cloud.height, 0x55);
    setPlane(cloud, testCamera(32, 24), Eigen::Vector3d(0.0, 0.0, -1.0), 1.25);
    std::reverse(cloud.fields.begin(), cloud.fields.end());
    std::vector<std::uint8_t> depth;
    const Validation found = validate(cloud, {}, depth);
    ASSERT_TRUE(found.accepted()) << explain(found.refusal, cloud);
    EXPECT_NEAR(testCamera(32, 24).fx, found.camera.fx, 1e-3);
    std::vector<float> row(32);
    ASSERT_EQ(32, loadRow(found.view, 23, {}, row.data()));
    EXPECT_FLOAT_EQ(1.25F, row[31]);
  }
}

TEST(CloudLayout, namesTheFieldThatIsWrong) {
  sensor_msgs::PointCloud2 cloud = testCloud(32, 24);
  cloud.fields[0].datatype = sensor_msgs::PointField::FLOAT64;
  cloud.fields[1].offset = 1000;
  cloud.fields[2].name = "intensity";
  const std::string text = explain(Refusal::kCloudFields, cloud);
  EXPECT_NE(std::string::npos, text.find("(x is FLOAT64, y lies outside of its point, there is no z)"))
      << text;
}

}  // namespace
}  // namespace line_plane_segmentation
