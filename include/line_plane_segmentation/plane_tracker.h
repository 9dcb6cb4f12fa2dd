// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// Limits for matching a plane to one of an earlier image. They are wide, because the best of all candidates
/// is chosen, and because coefficients jump when two planes are segmented as one in some images only.
struct TrackingParameters {
  /// [-] Keep the ids of planes over time. Switch off to use a plane's label as its id.
  bool track_planes = true;
  /// [s] Time for which an invisible plane keeps its id. Increase to bridge longer occlusions;
  /// decrease to give returning planes new ids earlier.
  double track_memory = 3.0;
  /// [deg] Largest rotation of a plane's normal between two images. Increase to follow faster
  /// motion, at the risk of wrong matches; decrease to avoid wrong matches.
  double track_angle = 45.0;
  /// [-] Largest deviation of a plane from its expected position, as a fraction of its depth.
  /// Increase to follow faster motion, at the risk of wrong matches; decrease to avoid wrong
  /// matches.
  double track_distance = 0.1;
};

/// Calls `visitor(name, value, min, max)` for each parameter, as visitParameters() does for the method's.
template <typename ParametersType, typename Visitor>
void visitTrackingParameters(ParametersType& p, Visitor&& visitor) {
  visitor("track_planes", p.track_planes, false, true);
  visitor("track_memory", p.track_memory, 0.0, 60.0);
  visitor("track_angle", p.track_angle, 1.0, 90.0);
  visitor("track_distance", p.track_distance, 0.001, 10.0);
}

/// Largest number of tracked planes of one image, the largest ones. Bounds memory and time.
constexpr std::size_t kMaxTrackedPlanes = 1024;

/// Id of a plane beyond that number: this value plus its label. It changes from image to image.
constexpr std::uint32_t kFirstUntrackedId = 0xFFFF0000U;

/// Assigns ids to planes that stay the same from image to image, while a surface is in view and during short
/// occlusions.
///
/// For each plane the tracker stores the coefficients and sample points on a coarse grid of pixels. In the
/// next image it projects the points with the camera's motion or, if the motion is unknown, compares the same
/// pixels. A plane is matched to the earlier plane with the largest fraction of common points, if their
/// coefficients are similar. Planes without common points, after an occlusion or a sudden motion, are matched
/// by their coefficients.
///
/// Objects can divide a surface, which is then segmented as one plane in some images and as several in
/// others. Parallel planes that were once segmented as one are parts of one surface from then on. The id of
/// the surface belongs to its largest visible part.
///
/// Ids count from 1 and are never reused before reset(). The same sequence of input gives the same ids. No
/// memory is allocated after the first images, and the stored data is bounded. Not thread-safe.
class PlaneTracker {
 public:
  explicit PlaneTracker(const TrackingParameters& parameters = {});
  ~PlaneTracker();
  PlaneTracker(PlaneTracker&&) noexcept;
  PlaneTracker& operator=(PlaneTracker&&) noexcept;

  /// Takes effect with the next image.
  void setParameters(const TrackingParameters& parameters);

  /// Matches the planes of an image to those of earlier images.
  /// @param seconds  [s] timestamp of the image, not before the last one's; call reset() before going back
  /// @param motion   maps points of the last image's optical frame to this image's; null: unknown
  /// @return id per plane, in the order of segmentation.planes; valid until the next call
  const std::vector<std::uint32_t>& track(const Segmentation& segmentation, const CameraIntrinsics& camera,
                                          double seconds, const RigidTransform* motion = nullptr);

  /// Same for an Eigen::Isometry3d, whose layout depends on the compiler flags of the caller.
  template <int Options>
  const std::vector<std::uint32_t>& track(
      const Segmentation& segmentation, const CameraIntrinsics& camera, double seconds,
      const Eigen::Transform<double, 3, Eigen::Isometry, Options>* motion) {
    if (motion == nullptr) return track(segmentation, camera, seconds);
    const RigidTransform unaligned(*motion);
    return track(segmentation, camera, seconds, &unaligned);
  }

  /// Returns the number of planes of the last image beyond kMaxTrackedPlanes, which have no lasting id.
  std::size_t untracked() const;

  /// Removes all planes. The next id is 1.
  void reset();

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace line_plane_segmentation
