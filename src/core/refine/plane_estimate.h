// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "line_plane_segmentation/segmentation.h"
#include "planes/plane_clustering.h"
#include "planes/plane_fit.h"

namespace line_plane_segmentation {

/// The coefficients of a plane and how sure they are.
struct PlaneEstimate {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, toward the camera
  double d = 0.0;                                     ///< [m] normal . p + d = 0, positive
  Covariance4d covariance = Covariance4d::Zero();     ///< of (normal, d)
};

/// The plane of a cluster of candidates. Its regression weighs every pixel by the sensor's noise there, and
/// knows only pixels of flat candidates, none of the borders where surfaces run into each other: a surer
/// estimate than a fit to all pixels with the plane's label.
///
/// The covariance is that of the regression of the candidates' mean points, from what these deviate from the
/// plane, times a factor for errors that neighbouring candidates share, such as the steps of the disparity.
PlaneEstimate estimatePlane(const PlaneCluster& cluster);

/// The plane of a narrow surface, whose candidates reach its borders: by regression of all pixels with its
/// label along their rays. (The axes of their principal components follow the noise where the surface is as
/// narrow as the noise is large.)
///
/// The errors of its pixels are shared by many of them, since the disparity's steps run along the surface and
/// at its borders pixels see something else, too: its covariance takes them for no more than 48 independent
/// ones.
/// @param fit  the plane if the pixels are too few for a regression
PlaneEstimate estimateFromPixels(const PlaneFit& fit, const PointMoments& moments);

}  // namespace line_plane_segmentation
