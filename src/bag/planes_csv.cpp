// SPDX-License-Identifier: BSD-3-Clause
#include "planes_csv.h"

#include <limits>

#include "line_plane_segmentation/orientation.h"
#include "run_tool.h"

namespace line_plane_segmentation {
PlanesCsv::PlanesCsv(const std::filesystem::path& file) : stream_(file) {
  stream_
      << "topic,stamp,id,label,nx,ny,nz,d,centroid_x,centroid_y,centroid_z,inliers,rms,area,orientation\n";
}

void PlanesCsv::add(const std::string& topic, const PlaneArray& planes) {
  for (const Plane& plane : planes.planes) {
    stream_ << topic << ',' << planes.header.stamp << ',' << plane.id << ',' << plane.label;
    stream_.precision(std::numeric_limits<double>::max_digits10);
    for (const double coefficient : plane.coefficients.coef) stream_ << ',' << coefficient;
    stream_ << ',' << plane.centroid.x << ',' << plane.centroid.y << ',' << plane.centroid.z << ','
            << plane.inliers;
    stream_.precision(std::numeric_limits<float>::max_digits10);
    stream_ << ',' << plane.rms << ',' << plane.area << ','
            << nameOf(static_cast<Orientation>(plane.orientation)) << '\n';
  }
}

void PlanesCsv::close() {
  stream_.close();
  if (!stream_) throw BadInput("the table of planes cannot be written");
}

}  // namespace line_plane_segmentation
