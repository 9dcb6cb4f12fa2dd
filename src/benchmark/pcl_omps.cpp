// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/features/integral_image_normal.h>
#include <pcl/segmentation/organized_multi_plane_segmentation.h>

#include "pcl_baselines.h"

namespace line_plane_segmentation {
namespace {

/// A. Trevor, S. Gedikli, R. Rusu, H. Christensen, "Efficient organized point cloud segmentation with
/// connected components", 2013: set up as PCL's own demonstration does it, which has the paper's values.
class Omps : public Engine {
 public:
  explicit Omps(bool refine) : refine_(refine) {}

  void load(const BenchmarkFrame& frame) override {
    frame_ = &frame;
    cloud_ = organisedCloud(frame);
    min_inliers_ = pixelsAt(frame, 5000, 1000);
  }

  int segment() override {
    pcl::OrganizedMultiPlaneSegmentation<pcl::PointXYZ, pcl::Normal, pcl::Label> segmentation;
    prepare(segmentation);
    Regions regions;
    if (refine_) {
      segmentation.segmentAndRefine(regions);
    } else {
      segmentation.segment(regions);
    }
    return static_cast<int>(regions.size());
  }

  std::vector<std::uint16_t> labels() override {
    pcl::OrganizedMultiPlaneSegmentation<pcl::PointXYZ, pcl::Normal, pcl::Label> segmentation;
    prepare(segmentation);
    std::vector<pcl::ModelCoefficients> coefficients;
    std::vector<pcl::PointIndices> planes;
    if (refine_) {
      Regions regions;
      pcl::PointCloud<pcl::Label>::Ptr point_labels(new pcl::PointCloud<pcl::Label>);
      std::vector<pcl::PointIndices> label_indices, boundaries;
      segmentation.segmentAndRefine(regions, coefficients, planes, point_labels, label_indices, boundaries);
    } else {
      segmentation.segment(coefficients, planes);
    }
    return labelsOfOrganised(*frame_, planes);
  }

 private:
  using Regions = std::vector<pcl::PlanarRegion<pcl::PointXYZ>,
                              Eigen::aligned_allocator<pcl::PlanarRegion<pcl::PointXYZ>>>;

  void prepare(
      pcl::OrganizedMultiPlaneSegmentation<pcl::PointXYZ, pcl::Normal, pcl::Label>& segmentation) const {
    constexpr float kMaxDepthChange = 0.02F;
    constexpr float kNormalSmoothing = 20.0F;
    constexpr double kAngle = 3.0 * M_PI / 180.0;
    constexpr double kDistance = 0.02;

    pcl::PointCloud<pcl::Normal>::Ptr normals(new pcl::PointCloud<pcl::Normal>);
    pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
    estimation.setNormalEstimationMethod(estimation.COVARIANCE_MATRIX);
    estimation.setMaxDepthChangeFactor(kMaxDepthChange);
    estimation.setNormalSmoothingSize(kNormalSmoothing);
    estimation.setInputCloud(cloud_);
    estimation.compute(*normals);

    segmentation.setMinInliers(static_cast<unsigned>(min_inliers_));
    segmentation.setAngularThreshold(kAngle);
    segmentation.setDistanceThreshold(kDistance);
    segmentation.setInputNormals(normals);
    segmentation.setInputCloud(cloud_);
  }

  bool refine_;
  const BenchmarkFrame* frame_ = nullptr;
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud_;
  int min_inliers_ = 0;
};

}  // namespace

std::unique_ptr<Engine> makeOmps(bool refine) { return std::make_unique<Omps>(refine); }

}  // namespace line_plane_segmentation
