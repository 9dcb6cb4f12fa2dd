// SPDX-License-Identifier: BSD-3-Clause
#include "planes_csv.h"

#include <limits>
#include <sstream>

#include "line_plane_segmentation/orientation.h"

namespace line_plane_segmentation {

PlanesCsv::PlanesCsv(OutputFiles& files, const std::filesystem::path& file) : files_(files), file_(file) {
  files_.add(
      file_,
      std::string(
          "topic,stamp,id,label,nx,ny,nz,d,centroid_x,centroid_y,centroid_z,inliers,rms,area,orientation\n"));
}

void PlanesCsv::add(const std::string& topic, const PlaneArray& planes) {
  std::ostringstream rows;
  for (const Plane& plane : planes.planes) {
    rows << topic << ',' << planes.header.stamp << ',' << plane.id << ',' << plane.label;
    rows.precision(std::numeric_limits<double>::max_digits10);
    for (const double coefficient : plane.coefficients.coef) rows << ',' << coefficient;
    rows << ',' << plane.centroid.x << ',' << plane.centroid.y << ',' << plane.centroid.z << ','
         << plane.inliers;
    rows.precision(std::numeric_limits<float>::max_digits10);
    rows << ',' << plane.rms << ',' << plane.area << ','
         << nameOf(static_cast<Orientation>(plane.orientation)) << '\n';
  }
  files_.append(file_, rows.str());
}

}  // namespace line_plane_segmentation
