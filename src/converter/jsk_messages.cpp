// SPDX-License-Identifier: BSD-3-Clause
#include "jsk_messages.h"

#include <boost/make_shared.hpp>

#include "conversions_of_planes.h"

namespace line_plane_segmentation {

jsk_recognition_msgs::PolygonArray::Ptr jskPolygons(const PlaneArray& planes) {
  auto message = boost::make_shared<jsk_recognition_msgs::PolygonArray>();
  message->header = planes.header;
  for (const Plane& plane : planes.planes) {
    message->polygons.push_back(*polygon(planes, &plane));
    message->labels.push_back(plane.id);
    message->likelihood.push_back(1.0F);
  }
  return message;
}

jsk_recognition_msgs::ModelCoefficientsArray::Ptr jskCoefficients(const PlaneArray& planes) {
  auto message = boost::make_shared<jsk_recognition_msgs::ModelCoefficientsArray>();
  message->header = planes.header;
  for (const Plane& plane : planes.planes)
    message->coefficients.push_back(*modelCoefficients(planes, &plane));
  return message;
}

}  // namespace line_plane_segmentation
