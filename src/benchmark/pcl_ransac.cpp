// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/segmentation/sac_segmentation.h>

#include <numeric>

#include "pcl_baselines.h"

namespace line_plane_segmentation {
namespace {

/// The plane with the most points by RANSAC, then the next from the points that are left, while they are
/// many.
class Ransac : public Engine {
 public:
  void load(const BenchmarkFrame& frame) override {
    frame_ = &frame;
    cloud_ = validPoints(frame);
    min_inliers_ = static_cast<std::size_t>(pixelsAt(frame, 40000, 10000));
  }

  int segment() override {
    int planes = 0;
    extract([&planes](const pcl::PointIndices&) { ++planes; });
    return planes;
  }

  std::vector<std::uint16_t> labels() override {
    std::vector<pcl::PointIndices> planes;
    extract([&planes](const pcl::PointIndices& inliers) { planes.push_back(inliers); });
    return labelsOfValid(*frame_, planes);
  }

 private:
  // Calls `found` for each plane.
  template <typename Found>
  void extract(Found found) const {
    constexpr double kDistance = 0.02;
    constexpr int kIterations = 100;

    pcl::SACSegmentation<pcl::PointXYZ> segmentation;
    segmentation.setModelType(pcl::SACMODEL_PLANE);
    segmentation.setMethodType(pcl::SAC_RANSAC);
    segmentation.setDistanceThreshold(kDistance);
    segmentation.setMaxIterations(kIterations);
    segmentation.setInputCloud(cloud_);

    pcl::IndicesPtr left(new std::vector<int>(cloud_->size()));
    std::iota(left->begin(), left->end(), 0);
    pcl::PointIndices inliers;
    pcl::ModelCoefficients plane;
    while (left->size() >= min_inliers_) {
      segmentation.setIndices(left);
      segmentation.segment(inliers, plane);
      if (inliers.indices.size() < min_inliers_) break;
      found(inliers);
      left = without(*left, inliers.indices);
    }
  }

  pcl::IndicesPtr without(const std::vector<int>& all, const std::vector<int>& taken) const {
    std::vector<bool> is_taken(cloud_->size(), false);
    for (const int index : taken) is_taken[index] = true;
    pcl::IndicesPtr left(new std::vector<int>);
    left->reserve(all.size());
    for (const int index : all) {
      if (!is_taken[index]) left->push_back(index);
    }
    return left;
  }

  const BenchmarkFrame* frame_ = nullptr;
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud_;
  std::size_t min_inliers_ = 0;
};

}  // namespace

std::unique_ptr<Engine> makeRansac() { return std::make_unique<Ransac>(); }

}  // namespace line_plane_segmentation
