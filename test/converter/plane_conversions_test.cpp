// SPDX-License-Identifier: BSD-3-Clause
#include "conversions_of_planes.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <iostream>
#include <vector>

#ifdef LPS_WITH_JSK
#include "jsk_messages.h"
#endif

namespace line_plane_segmentation {
namespace {

// Three planes; the largest is a wall, the second a table.
class Conversion : public testing::Test {
 protected:
  Conversion() {
    planes_.header.frame_id = "camera";
    planes_.header.stamp = ros::Time(12.5);
    add(7, 1, 900, Plane::VERTICAL);
    add(9, 2, 500, Plane::HORIZONTAL_UP);
    add(4, 3, 100, Plane::HORIZONTAL_UP);
    labels_.encoding = "16UC1";
    labels_.width = 3;
    labels_.height = 2;
    labels_.step = 8;  // with two bytes of padding
    labels_.data = {1, 0, 2, 0, 0, 0, 2, 0, 2, 0, 3, 0, 2, 0, 2, 0};
  }

  void add(std::uint32_t id, std::uint16_t label, std::uint32_t inliers, std::uint8_t orientation) {
    Plane plane;
    plane.id = id;
    plane.label = label;
    plane.inliers = inliers;
    plane.orientation = orientation;
    plane.area = 1.0F;
    plane.coefficients.coef = {0.0, 0.0, -1.0, static_cast<double>(id)};
    for (int i = 0; i < 4; ++i) {
      geometry_msgs::Point32 point;
      point.x = static_cast<float>(i);
      plane.outline.points.push_back(point);
    }
    planes_.planes.push_back(plane);
  }

  PlaneArray planes_;
  sensor_msgs::Image labels_;
};

TEST_F(Conversion, choosesTheLargestOrWhatIsAskedFor) {
  EXPECT_EQ(7U, choosePlane(planes_, {})->id);
  EXPECT_EQ(9U, choosePlane(planes_, {0, Plane::HORIZONTAL_UP})->id);
  EXPECT_EQ(4U, choosePlane(planes_, {4, {}})->id);
  EXPECT_EQ(nullptr, choosePlane(planes_, {7, Plane::HORIZONTAL_UP}));
  EXPECT_EQ(nullptr, choosePlane(planes_, {5, {}}));
  EXPECT_EQ(nullptr, choosePlane({}, {}));
}

TEST_F(Conversion, knowsOrientationsByName) {
  EXPECT_EQ(Plane::HORIZONTAL_UP, orientationNamed("horizontal_up").value());
  EXPECT_EQ(Plane::SLANTED, orientationNamed("slanted").value());
  EXPECT_EQ(Plane::UNKNOWN, orientationNamed("unknown").value());
  EXPECT_FALSE(orientationNamed("up"));
}

TEST_F(Conversion, givesCoefficientsAsPcl) {
  const auto message = modelCoefficients(planes_, &planes_.planes[1]);
  EXPECT_EQ(planes_.header, message->header);
  EXPECT_EQ((std::vector<float>{0.0F, 0.0F, -1.0F, 9.0F}), message->values);
  EXPECT_TRUE(modelCoefficients(planes_, nullptr)->values.empty());
}

TEST_F(Conversion, givesIndicesInTheCloud) {
  EXPECT_EQ((std::vector<std::int32_t>{1, 3, 5}),
            pointIndices(planes_, &planes_.planes[1], labels_)->indices);
  EXPECT_EQ((std::vector<std::int32_t>{0}), pointIndices(planes_, &planes_.planes[0], labels_)->indices);
  EXPECT_EQ(planes_.header, pointIndices(planes_, nullptr, labels_)->header);
  EXPECT_TRUE(pointIndices(planes_, nullptr, labels_)->indices.empty());
  labels_.is_bigendian = 1;
  labels_.data = {0, 1, 0, 2, 0, 0, 0, 0, 0, 2, 0, 3, 0, 2, 0, 0};
  EXPECT_EQ((std::vector<std::int32_t>{1, 3, 5}),
            pointIndices(planes_, &planes_.planes[1], labels_)->indices);
}

TEST_F(Conversion, takesNoMalformedLabels) {
  const auto is_empty = [&](const sensor_msgs::Image& labels) {
    return pointIndices(planes_, &planes_.planes[1], labels)->indices.empty();
  };
  sensor_msgs::Image labels = labels_;
  labels.data.pop_back();
  EXPECT_TRUE(is_empty(labels));
  labels = labels_;
  labels.step = 5;
  EXPECT_TRUE(is_empty(labels));
  labels = labels_;
  labels.encoding = "8UC1";
  EXPECT_TRUE(is_empty(labels));
  labels = labels_;
  labels.height = 4000000000U;
  EXPECT_TRUE(is_empty(labels));
  EXPECT_TRUE(is_empty({}));
}

TEST_F(Conversion, givesTheOutline) {
  const auto message = polygon(planes_, &planes_.planes[1]);
  EXPECT_EQ(planes_.header, message->header);
  EXPECT_EQ(planes_.planes[1].outline, message->polygon);
  EXPECT_TRUE(polygon(planes_, nullptr)->polygon.points.empty());
}

TEST_F(Conversion, drawsTheChoice) {
  const auto message = choiceMarkers(planes_, &planes_.planes[1]);
  ASSERT_EQ(3U, message->markers.size());
  EXPECT_EQ(visualization_msgs::Marker::DELETEALL, message->markers[0].action);
  EXPECT_EQ(5U, message->markers[1].points.size()) << "closed";
  EXPECT_EQ(2U, message->markers[2].points.size());
  EXPECT_EQ(1U, choiceMarkers(planes_, nullptr)->markers.size());
}

TEST_F(Conversion, givesAllPlanesToJsk) {
#ifdef LPS_WITH_JSK
  const auto polygons = jskPolygons(planes_);
  const auto coefficients = jskCoefficients(planes_);
  EXPECT_EQ(planes_.header, polygons->header);
  ASSERT_EQ(3U, polygons->polygons.size());
  EXPECT_EQ((std::vector<std::uint32_t>{7, 9, 4}), polygons->labels);
  EXPECT_EQ(3U, polygons->likelihood.size());
  EXPECT_EQ(planes_.planes[2].outline, polygons->polygons[2].polygon);
  ASSERT_EQ(3U, coefficients->coefficients.size());
  EXPECT_EQ(4U, coefficients->coefficients[2].values.size());
#else
  GTEST_SKIP() << "jsk_recognition_msgs is not installed: its messages were not built";
#endif
}

}  // namespace
}  // namespace line_plane_segmentation
