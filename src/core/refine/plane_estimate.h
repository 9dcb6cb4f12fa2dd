// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "line_plane_segmentation/eigen_types.h"
#include "planes/plane_clustering.h"
#include "planes/plane_fit.h"

namespace line_plane_segmentation {

/// The coefficients of a plane and how sure they are.
struct PlaneEstimate {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, toward the camera
  double d = 0.0;                                     ///< [m] normal . p + d = 0, positive
  Covariance4d covariance = Covariance4d::Zero();     ///< of (normal, d)
};

/// The plane of a cluster of patches. Its regression weighs every pixel by the sensor's noise there, and
/// knows only pixels of straight windows, none of the borders where surfaces run into each other: a surer
/// estimate than a fit to all pixels with the plane's label.
///
/// The covariance is that of the regression, from what the pixels deviate, times a factor for errors that
/// pixels have in common: each is counted in up to two windows, and the steps of the disparity move
/// neighbours alike.
PlaneEstimate estimatePlane(const PlaneCluster& cluster);

/// The plane of a narrow surface, whose patches reach its borders, or of one beside a step: by PCA of all
/// pixels with its label.
///
/// The errors of its pixels are shared by many of them, since the disparity's steps run along the surface and
/// at its borders pixels see something else, too: its covariance takes them for no more than eight
/// independent ones.
PlaneEstimate estimateFromPixels(const PlaneFit& fit, const PointMoments& moments);

}  // namespace line_plane_segmentation
