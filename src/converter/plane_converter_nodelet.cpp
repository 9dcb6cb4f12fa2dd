// SPDX-License-Identifier: BSD-3-Clause
#include "plane_converter_nodelet.h"

#include <ros/console.h>
#include <ros/node_handle.h>

#include <exception>
#include <pluginlib/class_list_macros.hpp>
#include <stdexcept>
#include <string>

#ifdef LPS_WITH_JSK
#include "jsk_messages.h"
#endif

namespace line_plane_segmentation {
namespace {

constexpr unsigned kQueueSize = 10;

bool hasSubscriber(const ros::Publisher& publisher) { return publisher && publisher.getNumSubscribers() > 0; }

// roscpp takes a parameter of the wrong type for one that is not set.
template <typename T>
T parameter(const ros::NodeHandle& nh, const std::string& name, const T& fallback,
            const std::string& demand) {
  T value = fallback;
  if (nh.hasParam(name) && !nh.getParam(name, value))
    throw std::invalid_argument("~" + name + " must be " + demand);
  return value;
}

PlaneChoice choiceOf(const ros::NodeHandle& nh) {
  PlaneChoice choice;
  const std::string whole = "a whole number, 0 for the largest plane";
  const int id = parameter(nh, "id", 0, whole);
  if (id < 0) throw std::invalid_argument("~id must be " + whole);
  choice.id = static_cast<std::uint32_t>(id);
  const std::string names = "horizontal_up, horizontal_down, vertical, slanted, unknown, or empty for any";
  const std::string orientation = parameter<std::string>(nh, "orientation", "", names);
  if (orientation.empty()) return choice;
  choice.orientation = orientationNamed(orientation);
  if (!choice.orientation) throw std::invalid_argument("~orientation must be " + names);
  return choice;
}

}  // namespace

// Nothing may be thrown out of here: nodelet would go on using what it has deleted.
void PlaneConverterNodelet::onInit() {
  try {
    {
      const std::lock_guard<std::mutex> lock(connect_mutex_);
      start();
    }
    updateSubscriptions();
  } catch (const std::exception& exception) {
    ROS_ERROR("[%s] does not start: %s", getName().c_str(), exception.what());
  }
}

void PlaneConverterNodelet::start() {
  ros::NodeHandle& nh = getPrivateNodeHandle();
  choice_ = choiceOf(nh);
  const ros::SubscriberStatusCallback changed = [this](const ros::SingleSubscriberPublisher&) {
    updateSubscriptions();
  };
  model_ = nh.advertise<pcl_msgs::ModelCoefficients>("model", kQueueSize, changed, changed);
  inliers_ = nh.advertise<pcl_msgs::PointIndices>("inliers", kQueueSize, changed, changed);
  polygon_ = nh.advertise<geometry_msgs::PolygonStamped>("polygon", kQueueSize, changed, changed);
  markers_ = nh.advertise<visualization_msgs::MarkerArray>("markers", kQueueSize, changed, changed);
#ifdef LPS_WITH_JSK
  jsk_polygons_ =
      nh.advertise<jsk_recognition_msgs::PolygonArray>("polygon_array", kQueueSize, changed, changed);
  jsk_coefficients_ = nh.advertise<jsk_recognition_msgs::ModelCoefficientsArray>(
      "coefficients_array", kQueueSize, changed, changed);
#endif
  planes_.registerCallback(&PlaneConverterNodelet::convert, this);
  is_ready_ = true;
}

template <typename Message>
void PlaneConverterNodelet::subscribe(message_filters::Subscriber<Message>& subscriber, const char* topic,
                                      bool is_wanted) {
  const bool is_subscribed = static_cast<bool>(subscriber.getSubscriber());
  if (is_wanted && !is_subscribed) subscriber.subscribe(getNodeHandle(), topic, kQueueSize);
  if (!is_wanted && is_subscribed) subscriber.unsubscribe();
}

void PlaneConverterNodelet::updateSubscriptions() {
  const std::lock_guard<std::mutex> lock(connect_mutex_);
  if (!is_ready_) return;
  bool is_wanted = false;
  for (const ros::Publisher* publisher :
       {&model_, &inliers_, &polygon_, &markers_, &jsk_polygons_, &jsk_coefficients_}) {
    is_wanted |= hasSubscriber(*publisher);
  }
  subscribe(planes_, "planes", is_wanted);
  const bool labels_are_wanted = hasSubscriber(inliers_);
  if (!labels_are_wanted) pairs_.reset();
  subscribe(labels_, "labels", labels_are_wanted);
  if (labels_are_wanted && !pairs_) {
    pairs_ = std::make_unique<message_filters::TimeSynchronizer<PlaneArray, sensor_msgs::Image>>(kQueueSize);
    pairs_->connectInput(planes_, labels_);
    pairs_->registerCallback(&PlaneConverterNodelet::publishInliers, this);
  }
}

void PlaneConverterNodelet::convert(const PlaneArray::ConstPtr& planes) {
  const Plane* plane = choosePlane(*planes, choice_);
  if (hasSubscriber(model_)) model_.publish(modelCoefficients(*planes, plane));
  if (hasSubscriber(polygon_)) polygon_.publish(polygon(*planes, plane));
  if (hasSubscriber(markers_)) markers_.publish(choiceMarkers(*planes, plane));
#ifdef LPS_WITH_JSK
  if (hasSubscriber(jsk_polygons_)) jsk_polygons_.publish(jskPolygons(*planes));
  if (hasSubscriber(jsk_coefficients_)) jsk_coefficients_.publish(jskCoefficients(*planes));
#endif
}

void PlaneConverterNodelet::publishInliers(const PlaneArray::ConstPtr& planes,
                                           const sensor_msgs::Image::ConstPtr& labels) {
  inliers_.publish(pointIndices(*planes, choosePlane(*planes, choice_), *labels));
}

}  // namespace line_plane_segmentation

PLUGINLIB_EXPORT_CLASS(line_plane_segmentation::PlaneConverterNodelet, nodelet::Nodelet)
