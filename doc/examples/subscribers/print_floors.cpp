// SPDX-License-Identifier: BSD-3-Clause
// Prints the horizontal planes that a segmenter publishes. Needs its parameter gravity_frame.
#include <line_plane_segmentation/PlaneArray.h>
#include <ros/ros.h>

void printFloors(const line_plane_segmentation::PlaneArray::ConstPtr& message) {
  for (const line_plane_segmentation::Plane& plane : message->planes) {
    if (plane.orientation == line_plane_segmentation::Plane::HORIZONTAL_UP)
      ROS_INFO("floor or table %u: %.2f m from the camera, %.2f m2", plane.id, plane.coefficients.coef[3],
               plane.area);
  }
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "print_floors");
  ros::NodeHandle nh;
  const ros::Subscriber subscriber = nh.subscribe("/camera/plane_segmenter/planes", 1, printFloors);
  ros::spin();
}
