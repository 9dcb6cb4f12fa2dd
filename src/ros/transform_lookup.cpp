// SPDX-License-Identifier: BSD-3-Clause
#include "transform_lookup.h"

#include <tf2/exceptions.h>
#include <tf2_eigen/tf2_eigen.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <sstream>

namespace line_plane_segmentation {
namespace {

using Status = TransformLookup::Status;

// tf accepts quaternions whose norm is off by half a percent; normalised here, since normals must have
// length 1.
Eigen::Isometry3d toEigen(const geometry_msgs::TransformStamped& message) {
  Eigen::Isometry3d transform = tf2::transformToEigen(message);
  transform.linear() = Eigen::Quaterniond(transform.linear()).normalized().toRotationMatrix();
  return transform;
}

// Farther away no point of a plane fits into a float with any precision left.
bool isUsable(const Eigen::Isometry3d& transform) {
  constexpr double kFarthest = 1e8;  // [m]
  return transform.translation().norm() <= kFarthest && transform.linear().allFinite();
}

// Newest time at which the transform is known, 0 if there is none.
ros::Time newest(const tf2::BufferCore& buffer, const std::string& target, const std::string& source) {
  try {
    return buffer.lookupTransform(target, source, ros::Time(0)).header.stamp;
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace

TransformLookup lookUp(const tf2::BufferCore& buffer, const std::string& target, const std::string& source,
                       const ros::Time& time) {
  TransformLookup lookup;
  if (target == source) {
    lookup.status = Status::kFound;
    return lookup;
  }
  try {
    lookup.transform = toEigen(buffer.lookupTransform(target, source, time));
    if (isUsable(lookup.transform)) {
      lookup.status = Status::kFound;
    } else {
      lookup.problem =
          "the transform from " + source + " to " + target + " has a translation that is not a position";
    }
  } catch (const tf2::ExtrapolationException& exception) {
    lookup.problem = exception.what();
    const ros::Time known = newest(buffer, target, source);
    // ros::Time::operator- throws if the difference is too large.
    // Where the clock goes back, the transforms of the new time come at about the time of the image.
    const bool is_too_old = known.toSec() - time.toSec() > tf2::BufferCore::DEFAULT_CACHE_TIME;
    lookup.missed_by = std::max(0.0, time.toSec() - known.toSec());
    if (known.isZero() || is_too_old) {
      lookup.status = Status::kUnknown;
    } else if (known < time || buffer.canTransform(target, source, time)) {
      // Or it arrived between the two lookups; the next one then finds it.
      lookup.status = Status::kLate;
    }
  } catch (const tf2::LookupException& exception) {
    lookup.problem = exception.what();
    lookup.status = Status::kUnknown;
  } catch (const tf2::ConnectivityException& exception) {
    lookup.problem = exception.what();
    lookup.status = Status::kUnknown;
  } catch (const std::exception& exception) {
    // tf2 also throws other exceptions, for times very far apart.
    lookup.problem = exception.what();
  }
  return lookup;
}

std::string explain(const TransformLookup& lookup, double patience) {
  if (lookup.status != Status::kLate) return lookup.problem;
  std::ostringstream text;
  text << lookup.problem << "; the newest is " << std::lround(1000.0 * lookup.missed_by)
       << " ms older than the image, " << std::lround(1000.0 * patience)
       << " ms were waited for it: raise ~tf_patience, or set ~tf_fallback to latest";
  return text.str();
}

bool ClockJumpDetector::jumpedBack(const std::string& child, const ros::Time& stamp) {
  ros::Time& newest = newest_[child];
  // ros::Time::operator- throws if the difference is too large.
  if (newest.toSec() - stamp.toSec() > tf2::BufferCore::DEFAULT_CACHE_TIME) {
    newest_ = {{child, stamp}};
    return true;
  }
  newest = std::max(newest, stamp);
  return false;
}

}  // namespace line_plane_segmentation
