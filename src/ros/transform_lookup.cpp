// SPDX-License-Identifier: BSD-3-Clause
#include "transform_lookup.h"

#include <tf2/exceptions.h>
#include <tf2_eigen/tf2_eigen.h>

#include <exception>

namespace line_plane_segmentation {
namespace {

using Answer = TransformLookup::Answer;

// tf takes quaternions whose length is off by half a percent, and normals are to have the length 1.
Eigen::Isometry3d toEigen(const geometry_msgs::TransformStamped& message) {
  Eigen::Isometry3d transform = tf2::transformToEigen(message);
  transform.linear() = Eigen::Quaterniond(transform.linear()).normalized().toRotationMatrix();
  return transform;
}

// The newest time for which the transform is known; 0 if there is none.
ros::Time newest(const tf2::BufferCore& buffer, const std::string& target, const std::string& source) {
  try {
    return buffer.lookupTransform(target, source, ros::Time(0)).header.stamp;
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace

TransformLookup lookUp(tf2::BufferCore& buffer, const std::string& target, const std::string& source,
                       const ros::Time& time) {
  TransformLookup lookup;
  if (target == source) {
    lookup.answer = Answer::kFound;
    return lookup;
  }
  try {
    lookup.transform = toEigen(buffer.lookupTransform(target, source, time));
    lookup.answer = Answer::kFound;
  } catch (const tf2::ExtrapolationException& exception) {
    lookup.problem = exception.what();
    ros::Time known = newest(buffer, target, source);
    // Not as a difference of times, which throws where it is too large.
    if (known.toSec() - time.toSec() > buffer.getCacheLength().toSec()) {
      buffer.clear();
      known = {};
    }
    if (known.isZero()) {
      lookup.answer = Answer::kUnknown;
    } else if (known < time || buffer.canTransform(target, source, time)) {
      // Or it came just now, between the two questions: then asking again finds it.
      lookup.answer = Answer::kLate;
    }
  } catch (const tf2::LookupException& exception) {
    lookup.problem = exception.what();
    lookup.answer = Answer::kUnknown;
  } catch (const tf2::ConnectivityException& exception) {
    lookup.problem = exception.what();
    lookup.answer = Answer::kUnknown;
  } catch (const std::exception& exception) {
    // Not tf2's alone: times that lie very far apart make it throw others.
    lookup.problem = exception.what();
  }
  return lookup;
}

}  // namespace line_plane_segmentation
