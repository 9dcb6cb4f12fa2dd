// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PointIndices.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <memory>

#include "engine.h"

/// Declarations that the baselines' sources share. Only they include it, because it includes PCL's headers.
namespace line_plane_segmentation {

std::unique_ptr<Engine> makeOmps(bool refine);
std::unique_ptr<Engine> makeRansac();
std::unique_ptr<Engine> makeRegionGrowing();

/// The organised cloud of a frame, NaN where there is no depth.
pcl::PointCloud<pcl::PointXYZ>::Ptr organisedCloud(const BenchmarkFrame& frame);

/// The points of a frame with valid depth, as an unorganised cloud.
pcl::PointCloud<pcl::PointXYZ>::Ptr validPoints(const BenchmarkFrame& frame);

/// The labels of a frame whose k-th plane are the points planes[k - 1] of its organised cloud.
std::vector<std::uint16_t> labelsOfOrganised(const BenchmarkFrame& frame,
                                             const std::vector<pcl::PointIndices>& planes);

/// The same for points of validPoints().
std::vector<std::uint16_t> labelsOfValid(const BenchmarkFrame& frame,
                                         const std::vector<pcl::PointIndices>& planes);

/// A number of pixels that the paper chose at VGA, and at QVGA, by the frame's size.
int pixelsAt(const BenchmarkFrame& frame, int at_vga, int at_qvga);

}  // namespace line_plane_segmentation
