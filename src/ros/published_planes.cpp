// SPDX-License-Identifier: BSD-3-Clause
#include "published_planes.h"

#include <cmath>
#include <cstddef>

#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

bool isPublished(const OrientationParameters& parameters, Orientation orientation) {
  switch (orientation) {
    case Orientation::kUnknown:
      return parameters.publish_unknown;
    case Orientation::kHorizontalUp:
      return parameters.publish_horizontal_up;
    case Orientation::kHorizontalDown:
      return parameters.publish_horizontal_down;
    case Orientation::kVertical:
      return parameters.publish_vertical;
    case Orientation::kSlanted:
      return parameters.publish_slanted;
  }
  return false;
}

void publishPlanes(const Segmentation& segmentation, const std::vector<std::uint32_t>& ids,
                   const std::optional<Eigen::Vector3d>& up, const OrientationParameters& parameters,
                   PublishedPlanes& published) {
  const double tolerance = parameters.orientation_tolerance * M_PI / 180.0;
  published.planes.clear();
  published.orientations.clear();
  for (std::size_t k = 0; k < segmentation.planes.size(); ++k) {
    const SegmentedPlane& plane = segmentation.planes[k];
    const Orientation orientation = up ? orientationOf(plane.normal, *up, tolerance) : Orientation::kUnknown;
    published.orientations.push_back(orientation);
    if (!isPublished(parameters, orientation)) continue;
    published.planes.push_back({transformed(plane, published.target_from_optical), ids[k], orientation});
  }

  const Eigen::Isometry3d& target_from_optical = published.target_from_optical;
  published.vertices.clear();
  for (const Eigen::Vector3f& vertex : segmentation.vertices) {
    published.vertices.push_back((target_from_optical * vertex.cast<double>()).cast<float>());
  }
}

}  // namespace line_plane_segmentation
