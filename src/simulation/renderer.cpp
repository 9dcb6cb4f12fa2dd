// SPDX-License-Identifier: BSD-3-Clause
#include "renderer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "image_row.h"
#include "projected_body.h"
#include "projected_face.h"

namespace line_plane_segmentation::simulation {
namespace {

/// [m] A plane that comes nearer than this to the camera is seen from its edge, which is: not at all.
constexpr double kEdgeOn = 1e-9;

/// All planes of the scene in the optical frame, by label; those seen from behind have d <= 0.
std::vector<VisiblePlane> toOpticalFrame(const std::vector<WorldPlane>& world_planes,
                                         const Eigen::Isometry3d& camera) {
  std::vector<VisiblePlane> planes;
  planes.reserve(world_planes.size());
  for (const WorldPlane& plane : world_planes) {
    const auto label = static_cast<std::uint16_t>(planes.size() + 1);
    planes.push_back(
        {label, camera.linear().transpose() * plane.normal(), plane.signedDistance(camera.translation()), 0});
  }
  return planes;
}

std::vector<ProjectedFace> projectFaces(const Scene& scene, const std::vector<VisiblePlane>& planes,
                                        const Eigen::Isometry3d& camera, const CameraIntrinsics& k,
                                        int height) {
  const Eigen::Isometry3d to_camera = camera.inverse();
  std::vector<ProjectedFace> faces;
  std::vector<Eigen::Vector3d> vertices;
  for (const Face& face : scene.faces()) {
    const VisiblePlane& plane = planes[face.label - 1U];
    if (!(plane.d > kEdgeOn)) continue;
    vertices.clear();
    for (const Eigen::Vector3d& vertex : face.vertices) vertices.push_back(to_camera * vertex);
    faces.emplace_back(vertices, plane, k, height);
  }
  return faces;
}

std::vector<ProjectedBody> projectBodies(const Scene& scene, const Eigen::Isometry3d& camera,
                                         const CameraIntrinsics& k) {
  std::vector<ProjectedBody> bodies;
  for (const CurvedBody& body : scene.curvedBodies()) {
    const ProjectedBody projected(body, camera, k);
    if (projected.visible()) bodies.push_back(projected);
  }
  return bodies;
}

void finishRow(const ImageRow& row, float* depth, std::uint16_t* labels) {
  for (std::size_t u = 0; u < row.labels.size(); ++u) {
    const double inverse = row.inverse_depth[u];
    depth[u] = static_cast<float>(inverse > 0.0 ? 1.0 / inverse : 0.0);
    labels[u] = static_cast<std::uint16_t>(row.labels[u]);
  }
}

void countPixels(const std::uint16_t* labels, std::size_t width, std::vector<VisiblePlane>& planes) {
  for (std::size_t first = 0; first < width;) {
    std::size_t end = first + 1;
    while (end < width && labels[end] == labels[first]) ++end;
    if (labels[first] != 0) planes[labels[first] - 1U].pixels += static_cast<std::uint32_t>(end - first);
    first = end;
  }
}

void removeUnseen(std::vector<VisiblePlane>& planes) {
  const auto unseen = [](const VisiblePlane& plane) { return plane.pixels == 0; };
  planes.erase(std::remove_if(planes.begin(), planes.end(), unseen), planes.end());
}

}  // namespace

void render(const Scene& scene, const Eigen::Isometry3d& camera, const CameraIntrinsics& intrinsics,
            int width, int height, Rendering& rendering) {
  if (!intrinsics.isValid()) throw std::invalid_argument("the intrinsics are not valid");
  if (width < 0 || height < 0) throw std::invalid_argument("the size is negative");
  const auto columns = static_cast<std::size_t>(width);
  rendering.width = width;
  rendering.height = height;
  rendering.depth.resize(columns * static_cast<std::size_t>(height));
  rendering.labels.resize(rendering.depth.size());
  rendering.planes = toOpticalFrame(scene.planes(), camera);

  const auto faces = projectFaces(scene, rendering.planes, camera, intrinsics, height);
  const auto bodies = projectBodies(scene, camera, intrinsics);
  ImageRow row(columns);
  for (int v = 0; v < height; ++v) {
    row.clear();
    for (const ProjectedFace& face : faces) face.draw(v, row);
    for (const ProjectedBody& body : bodies) body.draw(v, row);
    float* depth = rendering.depth.data() + static_cast<std::size_t>(v) * columns;
    std::uint16_t* labels = rendering.labels.data() + static_cast<std::size_t>(v) * columns;
    finishRow(row, depth, labels);
    countPixels(labels, columns, rendering.planes);
  }
  removeUnseen(rendering.planes);
}

void toMillimetres(const Rendering& rendering, std::uint16_t* depth_mm) {
  for (const float depth : rendering.depth) {
    const double rounded = std::floor(depth * 1000.0 + 0.5);
    *depth_mm++ = static_cast<std::uint16_t>(rounded <= 65535.0 ? rounded : 0.0);
  }
}

}  // namespace line_plane_segmentation::simulation
