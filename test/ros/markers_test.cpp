// SPDX-License-Identifier: BSD-3-Clause
// Markers of a floor and a table top in front of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "conversions.h"
#include "frame_segmenter.h"
#include "line_plane_segmentation/palette.h"
#include "test_messages.h"

namespace line_plane_segmentation {
namespace {

using visualization_msgs::Marker;

constexpr std::uint32_t kWidth = 320;
constexpr std::uint32_t kHeight = 240;

const Eigen::Vector3d kUp = Eigen::Vector3d(0.0, -0.8, -0.6);
constexpr double kFloor = 1.6;  // [m] below the camera
constexpr double kTable = 0.9;

class MarkersTest : public testing::Test {
 protected:
  MarkersTest() {
    auto image = boost::make_shared<sensor_msgs::Image>(imageOfPlane(kWidth, kHeight, "32FC1", kUp, kFloor));
    const sensor_msgs::Image table = imageOfPlane(kWidth, kHeight, "32FC1", kUp, kTable);
    for (std::size_t v = 90; v < 150; ++v) {
      const auto row = static_cast<std::ptrdiff_t>(v * image->step);
      std::copy_n(table.data.begin() + row + 4 * 100, 4 * 120, image->data.begin() + row + 4 * 100);
    }
    frame_.image = image;
    frame_.info = boost::make_shared<sensor_msgs::CameraInfo>(testInfo(kWidth, kHeight));
    published_.header.frame_id = "world";
    published_.target_from_optical.linear() =
        Eigen::Quaterniond::FromTwoVectors(kUp, Eigen::Vector3d::UnitZ()).matrix();
    published_.target_from_optical.translation() = Eigen::Vector3d(3.0, 2.0, kFloor);
  }

  SegmentedFrame segment(Method method = Method::kAdaptive) {
    Parameters parameters;
    parameters.method = method;
    segmenter_.setParameters(parameters);
    EXPECT_TRUE(segmenter_.accept(frame_).accepted());
    const Segmentation& segmentation = segmenter_.segment();
    EXPECT_EQ(2U, segmentation.planes.size());
    publishPlanes(segmentation, {17, 5}, kUp, OrientationParameters{}, published_);
    return segmenter_.result(published_);
  }

  static std::vector<Marker> ofNamespace(const visualization_msgs::MarkerArray& message,
                                         const std::string& ns) {
    EXPECT_EQ(Marker::DELETEALL, message.markers.at(0).action);
    std::vector<Marker> found;
    for (const Marker& marker : message.markers) {
      EXPECT_EQ("world", marker.header.frame_id);
      if (marker.ns == ns && marker.action == Marker::ADD) found.push_back(marker);
    }
    return found;
  }

  // In the world frame the floor is at height 0.
  static bool isOnSurface(double z, double tolerance) {
    return std::min(std::abs(z), std::abs(z - (kFloor - kTable))) < tolerance;
  }

  InputFrame frame_;
  FrameSegmenter segmenter_;
  PublishedPlanes published_;
};

TEST_F(MarkersTest, tellIdAreaAndOrientation) {
  const auto message = planeMarkers(segment());
  const std::vector<Marker> texts = ofNamespace(*message, "ids");
  ASSERT_EQ(2U, texts.size());
  EXPECT_EQ(0U, texts[0].text.find("17: ")) << texts[0].text;
  EXPECT_NE(std::string::npos, texts[0].text.find(" m^2\nhorizontal up")) << texts[0].text;
  EXPECT_EQ(0U, texts[1].text.find("5: 0.")) << texts[1].text;
  for (const std::size_t k : {0U, 1U}) {
    const double lower_edge = texts[k].pose.position.z - 1.2 * texts[k].scale.z * kUp.head<2>().norm();
    EXPECT_GT(lower_edge, k == 0 ? 0.02 : kFloor - kTable + 0.02) << "sinks into its plane";
  }
}

// The colour depends on the id, not on the label.
TEST_F(MarkersTest, haveTheColorsOfTheIds) {
  const auto message = planeMarkers(segment());
  for (const char* ns : {"outlines", "normals"}) {
    const std::vector<Marker> markers = ofNamespace(*message, ns);
    ASSERT_EQ(2U, markers.size());
    for (std::size_t k : {0U, 1U}) {
      const Color color = colorOf(k == 0 ? 17 : 5);
      EXPECT_EQ(k == 0 ? 17 : 5, markers[k].id);
      EXPECT_NEAR(0.6 + 0.4 * color.r / 255.0, markers[k].color.r, 1e-6);
      EXPECT_NEAR(0.6 + 0.4 * color.g / 255.0, markers[k].color.g, 1e-6);
      EXPECT_NEAR(0.6 + 0.4 * color.b / 255.0, markers[k].color.b, 1e-6);
    }
  }
}

TEST_F(MarkersTest, outlinesHaveHoles) {
  const auto message = planeMarkers(segment());
  const Marker floor = ofNamespace(*message, "outlines").at(0);
  EXPECT_EQ(1, published_.planes.at(0).plane.hole_count);
  int around_the_table = 0;
  for (const geometry_msgs::Point& point : floor.points) {
    EXPECT_NEAR(0.0, point.z, 0.005);
    const Eigen::Vector3d p =
        published_.target_from_optical.inverse() * Eigen::Vector3d(point.x, point.y, point.z);
    const CameraIntrinsics camera = testCamera(kWidth, kHeight);
    const double u = camera.fx * p.x() / p.z() + camera.cx, v = camera.fy * p.y() / p.z() + camera.cy;
    around_the_table += std::abs(u - 160) < 70 && std::abs(v - 120) < 40 ? 1 : 0;
  }
  EXPECT_GE(around_the_table, 8) << "four edges, two ends each";
}

// The floor's centroid is occluded by the table.
TEST_F(MarkersTest, arrowsStandWhereThePlaneIsSeen) {
  const auto message = planeMarkers(segment());
  const std::vector<Marker> arrows = ofNamespace(*message, "normals");
  for (std::size_t k : {0U, 1U}) {
    const geometry_msgs::Point& foot = arrows.at(k).points.at(0);
    const geometry_msgs::Point& tip = arrows[k].points.at(1);
    EXPECT_NEAR(k == 0 ? 0.0 : kFloor - kTable, foot.z, 0.01);
    EXPECT_GT(tip.z, foot.z + 0.05);
    EXPECT_NEAR(foot.x, tip.x, 0.01);
    const Eigen::Vector3d p =
        published_.target_from_optical.inverse() * Eigen::Vector3d(foot.x, foot.y, foot.z);
    const CameraIntrinsics camera = testCamera(kWidth, kHeight);
    const auto u = static_cast<std::size_t>(std::lround(camera.fx * p.x() / p.z() + camera.cx));
    const auto v = static_cast<std::size_t>(std::lround(camera.fy * p.y() / p.z() + camera.cy));
    EXPECT_EQ(k + 1, segmenter_.segmentation().labels.at(v * kWidth + u));
  }
}

TEST_F(MarkersTest, scanlinesLieOnTheSurfacesAndNormalsStandOnThem) {
  for (const Method method : {Method::kAdaptive, Method::kPaper}) {
    SCOPED_TRACE(static_cast<int>(method));
    const SegmentedFrame result = segment(method);
    const auto message = scanlineMarkers(result, segmenter_.lineSegments(), segmenter_.candidates());
    for (const char* ns : {"rows", "columns", "candidates"}) {
      SCOPED_TRACE(ns);
      const std::vector<Marker> markers = ofNamespace(*message, ns);
      ASSERT_EQ(1U, markers.size());
      EXPECT_EQ(Marker::LINE_LIST, markers[0].type);
      const std::vector<geometry_msgs::Point>& points = markers[0].points;
      ASSERT_EQ(0U, points.size() % 2);
      EXPECT_GE(points.size(), 2 * 15U);
      std::size_t right = 0;
      for (std::size_t i = 0; i < points.size(); i += 2) {
        const bool stands =
            points[i + 1].z > points[i].z + 0.03 && std::abs(points[i].x - points[i + 1].x) < 0.02;
        const bool lies = isOnSurface(points[i + 1].z, 0.02);
        right += isOnSurface(points[i].z, 0.02) && (std::string(ns) == "candidates" ? stands : lies) ? 1 : 0;
      }
      // The others come from windows across the table's edge.
      EXPECT_GE(2 * right, points.size() * 95 / 100);
    }
  }
}

// Nothing is drawn if nothing was found, and for lines that run to the horizon.
TEST_F(MarkersTest, scanlinesOutOfRangeAreLeftOut) {
  LineSegment segment;
  segment.scanline = 120;
  segment.first = 100;
  segment.last = 200;
  segment.r = 2.0;
  PlaneCandidate candidate;
  candidate.normal = Eigen::Vector3d(0.0, 0.0, -1.0);
  candidate.d = 2.0;
  const SegmentedFrame result = this->segment();
  EXPECT_EQ(3U, scanlineMarkers(result, {segment}, {candidate})->markers.size());
  EXPECT_EQ(1U, scanlineMarkers(result, {}, {})->markers.size());
  for (const double r : {0.0, 1e-3, 1e9, -1.0, std::nan("")}) {
    segment.r = candidate.d = r;
    EXPECT_EQ(1U, scanlineMarkers(result, {segment}, {candidate})->markers.size()) << r;
  }
  segment.r = 2.0;
  segment.alpha = M_PI / 2;  // along the line of sight
  EXPECT_EQ(1U, scanlineMarkers(result, {segment}, {})->markers.size());
}

}  // namespace
}  // namespace line_plane_segmentation
