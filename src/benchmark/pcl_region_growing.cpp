// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/features/normal_3d.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/region_growing.h>

#include <limits>

#include "pcl_baselines.h"

namespace line_plane_segmentation {
namespace {

/// Region growing by smoothness (Rabbani et al. 2006) over nearest neighbours from a k-d tree.
class RegionGrowing : public Engine {
 public:
  void load(const BenchmarkFrame& frame) override {
    frame_ = &frame;
    cloud_ = validPoints(frame);
    min_inliers_ = pixelsAt(frame, 5000, 1000);
  }

  int segment() override { return static_cast<int>(clusters().size()); }

  std::vector<std::uint16_t> labels() override { return labelsOfValid(*frame_, clusters()); }

 private:
  std::vector<pcl::PointIndices> clusters() const {
    constexpr int kNormalNeighbours = 100;
    constexpr unsigned kGrowingNeighbours = 20;
    constexpr float kAngle = static_cast<float>(3.0 * M_PI / 180.0);
    constexpr float kAnyCurvature = 1.0F;

    if (cloud_->empty()) return {};
    pcl::search::KdTree<pcl::PointXYZ>::Ptr tree(new pcl::search::KdTree<pcl::PointXYZ>);
    pcl::PointCloud<pcl::Normal>::Ptr normals(new pcl::PointCloud<pcl::Normal>);
    pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
    estimation.setSearchMethod(tree);
    estimation.setKSearch(kNormalNeighbours);
    estimation.setInputCloud(cloud_);
    estimation.compute(*normals);

    pcl::RegionGrowing<pcl::PointXYZ, pcl::Normal> growing;
    growing.setSearchMethod(tree);
    growing.setMinClusterSize(min_inliers_);
    growing.setMaxClusterSize(std::numeric_limits<int>::max());
    growing.setNumberOfNeighbours(kGrowingNeighbours);
    growing.setSmoothnessThreshold(kAngle);
    growing.setCurvatureThreshold(kAnyCurvature);
    growing.setInputCloud(cloud_);
    growing.setInputNormals(normals);
    std::vector<pcl::PointIndices> clusters;
    growing.extract(clusters);
    return clusters;
  }

  const BenchmarkFrame* frame_ = nullptr;
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud_;
  int min_inliers_ = 0;
};

}  // namespace

std::unique_ptr<Engine> makeRegionGrowing() { return std::make_unique<RegionGrowing>(); }

}  // namespace line_plane_segmentation
