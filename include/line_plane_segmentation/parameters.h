// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

namespace line_plane_segmentation {

/// Method of the segmentation.
enum class Method : int {
  kPaper = 0,     ///< the published method: fixed distances
  kAdaptive = 1,  ///< tolerances that follow the sensor's noise, and refined labels
};

/// Returns the method's public name: "paper" or "adaptive".
const char* nameOf(Method method);

/// Standard deviation of a depth z along the optical axis, Eq. 5 (after Nguyen et al. 2012):
/// sigma_z = floor + growth * (z - nearest)^2.
struct NoiseParameters {
  /// [m] Standard deviation of the depth at the distance noise_nearest (Eq. 5). Increase to
  /// tolerate noisier sensors and rougher surfaces; decrease to separate lower steps.
  double floor = 0.0012;
  /// [1/m] Growth of the depth noise with the squared distance (Eq. 5). Increase to keep distant
  /// planes whole; decrease to separate distant parallel planes.
  double growth = 0.0019;
  /// [m] Distance of the smallest depth noise (Eq. 5). Increase to let the noise grow from farther
  /// away; decrease to let it grow from nearer.
  double nearest = 0.4;
  /// [-] Multiple of the noise model; 0 = noise and distortion are measured in each image, 1 to 4 and 1 to 2
  /// times. Increase above 1 for noisier images without a measurement; decrease to 1 to use the model
  /// unchanged.
  double scale = 0.0;

  /// Returns the standard deviation [m] at the depth z [m].
  double sigma(double z) const { return floor + growth * (z - nearest) * (z - nearest); }
};

/// Range of the depth, and distance of the scanlines.
struct ScanlineParameters {
  /// [m] Smallest valid depth; nearer pixels are ignored. Increase to ignore parts of the robot;
  /// decrease to segment nearer surfaces.
  double min_range = 0.3;
  /// [m] Largest valid depth; farther pixels are ignored. Increase to segment farther surfaces,
  /// where the noise is larger; decrease to ignore them.
  double max_range = 10.0;
  /// [px] Distance between scanlines, 0 = from the image width; paper: 30 (VGA), 20 (QVGA).
  /// Increase to save time; decrease to find smaller planes.
  int scanline_spacing = 0;
};

/// Line regression, Algorithm 1.
///
/// The paper does not state the bound of the fidelity. It was calibrated on simulated scans with independent
/// noise of Eq. 5 per pixel, at 0.8 to 2.5 m (test/core/line_fidelity_test.cpp). With a bound of 4:
/// - 93 to 84 % (VGA) and 82 to 76 % (QVGA) of the windows on a plane are accepted;
/// - segments cover 98 to 90 % (VGA) and 94 to 87 % (QVGA) of the plane;
/// - segments cross no step of 10 cm, no crease of 90 degrees, at most 5 % of the creases of 60 degrees, and
/// a
///   quarter of those of 30 degrees.
///
/// With a bound of 3, 15 to 20 % of a distant plane are lost; with 6, half of the creases of 30 degrees. The
/// noise of a real sensor is correlated between pixels, so more windows are accepted.
struct LineParameters {
  /// [px] Number of points of a line fit, Nf, 0 = from the image width, at most half of scanline_spacing;
  /// paper: 11 (VGA), 7 (QVGA). Increase to reduce the effect of noise; decrease to find shorter segments.
  int line_window = 0;
  /// [px] Shortest line segment, Nl, 0 = one less than line_window; paper: 30 (VGA), 23 (QVGA). Increase
  /// to get fewer, more reliable candidates; decrease to find smaller planes.
  int min_line_points = 0;
  /// [-] Largest Mahalanobis distance of three adjacent windows. Increase to accept bent lines as
  /// straight; decrease to split lines at smaller bends.
  double line_fidelity = 4.0;
  /// [-] Noise along the scan as a multiple of Eq. 5. Increase to tolerate coarser quantisation;
  /// decrease to split lines at smaller deviations.
  double line_noise_factor = 1.0;
};

/// Plane candidates by principal component analysis (PCA).
struct CandidateParameters {
  /// [-] Number of candidates per line segment: 1, 3 or 5. Increase to find more small planes;
  /// decrease to save time.
  int points_per_segment = 1;
  /// [px] Side of the window of the principal component analysis, 0 = from the image width; paper:
  /// 20. Increase to get more accurate normals; decrease to get candidates closer to edges.
  int normal_window = 0;
  /// [px] Smallest number of valid pixels in that window, Ns, 0 = from the image width; paper: 240.
  /// Increase to drop candidates near holes; decrease to keep them.
  int min_window_points = 0;
  /// [-] Largest ratio of the smallest eigenvalue to the sum of all three. Increase to start planes
  /// on rougher surfaces; decrease to start them on flat surfaces only.
  double max_curvature = 0.05;
};

/// Recursive extraction, Algorithm 2.
struct ExtractionParameters {
  /// [m] Largest orthogonal distance of a pixel from its plane, delta_d. Increase to tolerate
  /// noisier sensors; decrease to separate parallel planes.
  double plane_distance = 0.02;
  /// [m] Largest distance between neighbouring points of a plane, delta_n. Increase to bridge gaps
  /// and steps; decrease to separate surfaces at smaller steps.
  double neighbor_distance = 0.03;
  /// [-] Smallest value of both distances in standard deviations of the depth (Eq. 5). Increase to
  /// keep distant planes whole; decrease to separate distant parallel planes.
  double distance_noise_factor = 3.0;
  /// [px] Smallest plane, N, 0 = from the image width; paper: 5000 (VGA), 1000 (QVGA). Increase to
  /// keep large planes only; decrease to find smaller planes.
  int min_plane_inliers = 0;
  /// [m²] Smallest visible area of a plane, 0 = no limit. Increase to keep large planes only;
  /// decrease to find smaller planes.
  double min_plane_area = 0.0;
};

/// Method adaptive: patches, which are local planes at the crossings of the scanlines.
struct PatchParameters {
  /// [-] Tolerance of a patch, and unit of the merge costs, as a multiple of the depth's standard
  /// deviation. Increase to tolerate coarser sensors; decrease to separate planes at blunt edges.
  double patch_noise_factor = 1.6;
  /// [m] Smallest tolerance, orthogonal to the plane. Increase to accept rougher surfaces nearby;
  /// decrease to separate lower steps nearby.
  double patch_distance = 0.004;
  /// [-] Largest mean squared error of a patch, and of a line segment of one window, in squared tolerances.
  /// Increase to accept rough and curved surfaces; decrease to accept flat surfaces only.
  double patch_flatness = 1.2;
};

/// Method adaptive: clustering of patches to planes.
struct ClusterParameters {
  /// [-] Largest squared error that a merge of two clusters adds per pixel of the smaller one, in
  /// squared tolerances. Increase to merge planes across blunt edges; decrease to separate them.
  double merge_cost = 4.4;
  /// [-] The same for two parts of a plane that an object in front separates, 0 = never. Increase
  /// to merge more parts across gaps; decrease to keep them separate.
  double coplanar_cost = 3.5;
  /// [-] Largest mean squared error of a small plane, in squared tolerances. Increase to accept
  /// parts of curved surfaces, including people; decrease to reject them.
  double max_curvedness = 1.0;
  /// [-] Largest mean squared deviation of a small plane's patches from it, in squared tolerances.
  /// Increase to accept rough surfaces, including people; decrease to reject them.
  double max_waviness = 0.25;
  /// [-] Largest mean squared deviation of a small plane towards a quadric surface, in squared
  /// tolerances. Increase to accept parts of smooth curved surfaces; decrease to reject them.
  double max_bend = 0.1;
  /// [-] Smallest number of patches of a plane, counted after coplanar parts are merged; 1 acts like
  /// 2. Increase to keep large planes only; decrease to find smaller planes.
  int min_patches = 3;
};

/// Method adaptive: removal of small regions from the label image.
struct CleanupParameters {
  /// [px] Size below which connected components and holes are assigned to their surroundings, 0 =
  /// from the image width. Increase to get smoother regions; decrease to keep finer details.
  int min_region_pixels = 0;
};

/// Outline polygons.
struct OutlineParameters {
  /// [-] Compute the outline polygons of the planes. Switch off to save time; outlines are then
  /// empty.
  bool trace_outlines = true;
  /// [px] Largest distance between a region's border and its polygon. Increase to get fewer
  /// vertices; decrease to follow the border more closely.
  double outline_tolerance = 2.0;
  /// [px] Smallest hole of an outline; smaller holes are closed. Increase to get simpler polygons;
  /// decrease to keep smaller holes.
  int min_hole_pixels = 100;
};

/// All parameters of the method. The defaults suit a Kinect or Xtion.
struct Parameters {
  Method method = Method::kAdaptive;
  NoiseParameters noise;
  ScanlineParameters scanlines;
  LineParameters lines;
  CandidateParameters candidates;
  ExtractionParameters extraction;
  PatchParameters patches;
  ClusterParameters clusters;
  CleanupParameters cleanup;
  OutlineParameters outlines;
};

/// Calls `visitor(name, value, min, max)` for every parameter; `value` is a reference to an int, double, bool
/// or Method. Command line, dynamic_reconfigure, Python and tests read the public names and bounds from this
/// list.
template <typename ParametersType, typename Visitor>
void visitParameters(ParametersType& p, Visitor&& visitor) {
  visitor("method", p.method, Method::kPaper, Method::kAdaptive);
  visitor("noise_floor", p.noise.floor, 1e-5, 0.1);
  visitor("noise_growth", p.noise.growth, 0.0, 0.1);
  visitor("noise_nearest", p.noise.nearest, 0.0, 5.0);
  visitor("noise_scale", p.noise.scale, 0.0, 100.0);
  visitor("min_range", p.scanlines.min_range, 0.0, 100.0);
  visitor("max_range", p.scanlines.max_range, 0.1, 1000.0);
  visitor("scanline_spacing", p.scanlines.scanline_spacing, 0, 200);
  visitor("line_window", p.lines.line_window, 0, 101);
  visitor("min_line_points", p.lines.min_line_points, 0, 1000);
  visitor("line_fidelity", p.lines.line_fidelity, 0.01, 1000.0);
  visitor("line_noise_factor", p.lines.line_noise_factor, 0.1, 100.0);
  visitor("points_per_segment", p.candidates.points_per_segment, 1, 5);
  visitor("normal_window", p.candidates.normal_window, 0, 200);
  visitor("min_window_points", p.candidates.min_window_points, 0, 40000);
  visitor("max_curvature", p.candidates.max_curvature, 1e-5, 1.0 / 3.0);
  visitor("plane_distance", p.extraction.plane_distance, 1e-4, 0.5);
  visitor("neighbor_distance", p.extraction.neighbor_distance, 1e-4, 1.0);
  visitor("distance_noise_factor", p.extraction.distance_noise_factor, 0.0, 20.0);
  visitor("min_plane_inliers", p.extraction.min_plane_inliers, 0, 1000000);
  visitor("min_plane_area", p.extraction.min_plane_area, 0.0, 100.0);
  visitor("patch_noise_factor", p.patches.patch_noise_factor, 0.0, 20.0);
  visitor("patch_distance", p.patches.patch_distance, 1e-5, 0.5);
  visitor("patch_flatness", p.patches.patch_flatness, 0.01, 100.0);
  visitor("merge_cost", p.clusters.merge_cost, 0.0, 1000.0);
  visitor("coplanar_cost", p.clusters.coplanar_cost, 0.0, 1000.0);
  visitor("max_curvedness", p.clusters.max_curvedness, 0.01, 1000.0);
  visitor("max_waviness", p.clusters.max_waviness, 0.0, 1000.0);
  visitor("max_bend", p.clusters.max_bend, 0.0, 1000.0);
  visitor("min_patches", p.clusters.min_patches, 1, 1000);
  visitor("min_region_pixels", p.cleanup.min_region_pixels, 0, 100000);
  visitor("trace_outlines", p.outlines.trace_outlines, false, true);
  visitor("outline_tolerance", p.outlines.outline_tolerance, 0.5, 20.0);
  visitor("min_hole_pixels", p.outlines.min_hole_pixels, 0, 1000000);
}

/// Returns a line that states that a parameter has no effect on a method; empty if it has an effect.
/// @param name  public name of the parameter
std::string noEffect(const std::string& name, Method method);

/// Returns the values of all parameters, in the order of visitParameters().
std::vector<double> valuesOf(const Parameters& parameters);

/// Names the parameters that were changed, but have no effect on the method.
/// @return one line per parameter, as from noEffect()
std::vector<std::string> changesWithoutEffect(const Parameters& before, const Parameters& after);

/// Limits every parameter to its bounds, replaces NaN by the default, sets points_per_segment to 1, 3 or 5,
/// line_window to at least 2 unless it is 0, and min_range to less than max_range.
/// @return one line per changed value, with its name; empty if no value was changed
std::vector<std::string> sanitize(Parameters& parameters);

/// Replaces each 0 that stands for a value by it: for lengths the method's at 640 and at 320 pixels,
/// interpolated between these widths, and scaled beyond them, so that sizes stay constant as viewing angles.
/// @param width  [px], at least 1: of the image for Method::kPaper, kinectWidthOf() for Method::kAdaptive
Parameters resolve(const Parameters& parameters, int width);

/// The presets: "kinect" (the defaults; Kinect v1, Xtion), "stereo" (stereo cameras of the D435 class),
/// "stereo_short" (stereo cameras for near things, D405), "tof" (time-of-flight cameras, Azure Kinect, L515),
/// "short_range" (scanners with millimetre steps and small parts) and "paper" (the published method).
constexpr std::array<const char*, 6> kPresetNames = {"kinect", "stereo",      "stereo_short",
                                                     "tof",    "short_range", "paper"};

/// Returns the names of the presets, separated by commas.
std::string presetNames();

/// Sets all parameters to a preset.
/// @return false if there is no preset of that name; `parameters` are then unchanged
bool loadPreset(const std::string& name, Parameters& parameters);

/// Sets one parameter from text such as "0.02", "true" or "paper".
/// @return error message about `name` or `value`; empty on success
std::string setParameter(const std::string& name, const std::string& value, Parameters& parameters);

}  // namespace line_plane_segmentation
