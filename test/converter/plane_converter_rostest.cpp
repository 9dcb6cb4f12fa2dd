// SPDX-License-Identifier: BSD-3-Clause
// The converter behind a segmenter, in one manager: lazy, and in agreement with the planes.
#include <geometry_msgs/PolygonStamped.h>
#include <gtest/gtest.h>
#include <line_plane_segmentation/PlaneArray.h>
#include <pcl_msgs/ModelCoefficients.h>
#include <pcl_msgs/PointIndices.h>
#include <ros/master.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <string>

#include "ros/test_camera.h"

namespace line_plane_segmentation {
namespace {

// True if somebody subscribes to the segmenter's outputs.
bool isSegmenterWanted() {
  XmlRpc::XmlRpcValue request, response, payload;
  request[0] = ros::this_node::getName();
  if (!ros::master::execute("getSystemState", request, response, payload, true)) return false;
  const XmlRpc::XmlRpcValue subscribers = payload[1];
  for (int i = 0; i < subscribers.size(); ++i) {
    const std::string topic = subscribers[i][0];
    if (topic == "/plane_segmenter/planes" || topic == "/plane_segmenter/labels") return true;
  }
  return false;
}

TEST(PlaneConverter, isIdleWithoutSubscribers) {
  spinFor(1.0);
  EXPECT_FALSE(isSegmenterWanted());
  {
    const Inbox<pcl_msgs::ModelCoefficients> model("plane_converter/model");
    EXPECT_TRUE(waitUntil(isSegmenterWanted));
  }
  EXPECT_TRUE(waitUntil([] { return !isSegmenterWanted(); }));
}

TEST(PlaneConverter, agreesWithThePlanes) {
  const Inbox<PlaneArray> planes("plane_segmenter/planes");
  const Inbox<pcl_msgs::ModelCoefficients> model("plane_converter/model");
  const Inbox<pcl_msgs::PointIndices> inliers("plane_converter/inliers");
  const Inbox<geometry_msgs::PolygonStamped> polygon("plane_converter/polygon");
  const Inbox<visualization_msgs::MarkerArray> markers("plane_converter/markers");
  // One image whose messages have all arrived.
  ASSERT_TRUE(waitUntil([&] {
    if (!planes.newest() || !model.newest() || !inliers.newest() || !polygon.newest() || !markers.newest())
      return false;
    const ros::Time stamp = planes.newest()->header.stamp;
    return !planes.newest()->planes.empty() && model.newest()->header.stamp == stamp &&
           inliers.newest()->header.stamp == stamp && polygon.newest()->header.stamp == stamp;
  }));
  const Plane& largest =
      *std::max_element(planes.newest()->planes.begin(), planes.newest()->planes.end(),
                        [](const Plane& a, const Plane& b) { return a.inliers < b.inliers; });
  ASSERT_EQ(4U, model.newest()->values.size());
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_FLOAT_EQ(static_cast<float>(largest.coefficients.coef[i]), model.newest()->values[i]);
  }
  EXPECT_EQ(largest.inliers, inliers.newest()->indices.size());
  EXPECT_EQ(largest.outline, polygon.newest()->polygon);
  EXPECT_EQ(3U, markers.newest()->markers.size());
  EXPECT_EQ(planes.newest()->header.frame_id, model.newest()->header.frame_id);
}

// A bag is repeated: planes of later times came before, without labels.
TEST(PlaneConverter, pairsPlanesWithLabelsAfterAJumpBackInTime) {
  ros::NodeHandle nh;
  const ros::Publisher planes = nh.advertise<PlaneArray>("bag/planes", 20);
  const ros::Publisher labels = nh.advertise<sensor_msgs::Image>("bag/labels", 20);
  const auto publish_planes = [&planes](const ros::Time& stamp) {
    PlaneArray message;
    message.header.stamp = stamp;
    planes.publish(message);
  };
  const Inbox<pcl_msgs::ModelCoefficients> model("bag_converter/model");
  ASSERT_TRUE(waitUntil([&] { return planes.getNumSubscribers() > 0; }));
  for (int i = 0; i < 20; ++i) publish_planes(ros::Time(100.0 + i));
  spinFor(0.5);

  const Inbox<pcl_msgs::PointIndices> inliers("bag_converter/inliers");
  ASSERT_TRUE(waitUntil([&] { return labels.getNumSubscribers() > 0; }));
  ros::Time stamp(1.0);
  EXPECT_TRUE(waitUntil([&] {
    sensor_msgs::Image image;
    image.header.stamp = stamp += ros::Duration(0.1);
    image.encoding = "16UC1";
    image.width = image.height = 1;
    image.step = 2;
    image.data.resize(2);
    publish_planes(stamp);
    labels.publish(image);
    return inliers.newest() != nullptr;
  }));
}

TEST(PlaneConverter, staysIdleWithAWrongParameterAndLeavesTheManagerAlive) {
  // Loaded by the launch file with an orientation that does not exist.
  ros::master::V_TopicInfo topics;
  ros::master::getTopics(topics);
  EXPECT_TRUE(std::none_of(topics.begin(), topics.end(), [](const ros::master::TopicInfo& topic) {
    return topic.name.find("/wrong_converter/model") != std::string::npos;
  }));
}

}  // namespace
}  // namespace line_plane_segmentation
