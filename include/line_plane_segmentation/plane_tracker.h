// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/eigen_types.h"
#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// When a plane is taken for one that was seen before. The bounds are wide since planes compete: what counts
/// is which one fits best. Where two planes are now seen as one, now as two, coefficients jump.
struct TrackingParameters {
  bool track_planes = true;     ///< ids stay with their planes; off -> a plane's id is its label
  double track_memory = 3.0;    ///< [s] that an unseen plane keeps its id. Higher -> longer absences
  double track_angle = 45.0;    ///< [deg] that a normal may turn by. Higher -> survives poorer segmentation,
                                ///< and more mistakes
  double track_distance = 0.1;  ///< [-] that a plane may be off from where it was expected, as a share of its
                                ///< depth. Higher -> survives faster motion, and more mistakes
};

/// As visitParameters() for the method's parameters: the one list of names and bounds.
template <typename ParametersType, typename Visitor>
void visitTrackingParameters(ParametersType& p, Visitor&& visitor) {
  visitor("track_planes", p.track_planes, false, true);
  visitor("track_memory", p.track_memory, 0.0, 60.0);
  visitor("track_angle", p.track_angle, 1.0, 90.0);
  visitor("track_distance", p.track_distance, 0.001, 10.0);
}

/// Planes of one image that are tracked at most: the first, which are the largest. It bounds memory and time.
constexpr std::size_t kMaxTrackedPlanes = 1024;

/// The planes beyond have ids from here on, this + their label, which change from image to image.
constexpr std::uint32_t kFirstUntrackedId = 0xFFFF0000U;

/// Gives planes ids that stay from image to image: the same surface keeps its id while it is in view and
/// for a short absence.
///
/// Of each plane it remembers the coefficients and points on a coarse grid of pixels. In the next image the
/// points are looked for where the camera's motion brings them or, if that is not known, at the same pixels:
/// a plane is the one before with which it shares the largest part of these points, if both lie alike. Planes
/// that share no points, after an absence or a sudden motion, are known again by their coefficients.
///
/// A surface that objects cut apart is seen now as one plane, now as several. Planes that were seen as one,
/// and lie in one direction, are parts of it from then on: its id goes with the largest of them that is in
/// view.
///
/// Ids count from 1 and none is used twice before reset(). The same sequence of input gives the same ids, bit
/// by bit. Allocates nothing once warm; what it remembers is bounded, whatever is seen. Not thread-safe.
class PlaneTracker {
 public:
  explicit PlaneTracker(const TrackingParameters& parameters = {});
  ~PlaneTracker();
  PlaneTracker(PlaneTracker&&) noexcept;
  PlaneTracker& operator=(PlaneTracker&&) noexcept;

  /// Takes effect with the next image.
  void setParameters(const TrackingParameters& parameters);

  /// @param seconds  [s] when the image was taken: not before the last one, for which there is reset()
  /// @param motion   takes points of the last image's optical frame to this one's; null: it is not known
  /// @return the id of each plane, in the order of segmentation.planes; valid until the next call
  const std::vector<std::uint32_t>& track(const Segmentation& segmentation, const CameraIntrinsics& camera,
                                          double seconds, const RigidTransform* motion = nullptr);

  /// The same for an Eigen::Isometry3d, whose layout depends on the flags of the caller.
  template <int Options>
  const std::vector<std::uint32_t>& track(
      const Segmentation& segmentation, const CameraIntrinsics& camera, double seconds,
      const Eigen::Transform<double, 3, Eigen::Isometry, Options>* motion) {
    if (motion == nullptr) return track(segmentation, camera, seconds);
    const RigidTransform unaligned(*motion);
    return track(segmentation, camera, seconds, &unaligned);
  }

  /// Number of planes of the last image beyond kMaxTrackedPlanes, which have no lasting id.
  std::size_t untracked() const;

  /// Forgets all planes, and begins again with id 1.
  void reset();

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace line_plane_segmentation
