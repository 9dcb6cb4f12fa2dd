// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace line_plane_segmentation {

/// Which extraction follows the candidates.
enum class Method : int {
  kPaper = 0,     ///< the paper to the letter: fixed distances
  kAdaptive = 1,  ///< distances that follow the sensor's noise, and the refinement of its result
};

/// The method's public name: "paper" or "adaptive".
const char* nameOf(Method method);

/// Standard deviation of a depth z along the optical axis, Eq. 5 (after Nguyen et al. 2012):
/// sigma_z = floor + growth * (z - nearest)^2.
struct NoiseParameters {
  double floor = 0.0012;   ///< [m] noise at the nearest distance. Higher -> everything counts as flatter
  double growth = 0.0019;  ///< [1/m] how fast noise grows. Higher -> more tolerance far away
  double nearest = 0.4;    ///< [m] where the noise is least
  double scale = 0.0;  ///< [-] multiple of this model; 0: as measured in each image, at least 1 and at most 4

  double sigma(double z) const { return floor + growth * (z - nearest) * (z - nearest); }
};

/// Which part of the depth image is scanned, and how densely. 0 means: from the image's width.
struct ScanlineParameters {
  double min_range = 0.3;   ///< [m] nearer depths count as missing
  double max_range = 10.0;  ///< [m] farther depths count as missing
  int scanline_spacing =
      0;  ///< [px] between scanlines; paper: 30 (VGA), 20 (QVGA). Higher -> faster, misses small planes
};

/// Line regression, Algorithm 1. 0 means: from the image's width.
///
/// The paper leaves the bound of the fidelity open. It was calibrated on simulated scans with the noise of
/// Eq. 5, drawn for each pixel alone, at 0.8 to 2.5 m (test/core/line_fidelity_test.cpp). With 4, of the
/// windows on a plane 93 to 84 % pass at VGA and 82 to 76 % at QVGA, and segments cover 98 to 90 % and 94 to
/// 87 % of it; segments run over no step of 10 cm and no crease of 90 degrees, over 5 % of the creases of 60
/// degrees at most, and over a quarter of those of 30. With 3 more of a far plane is lost (15 to 20 %), with
/// 6 half of the creases of 30 degrees. A real sensor's noise differs less from pixel to pixel, so that more
/// passes.
struct LineParameters {
  int line_window =
      0;  ///< [px] points of a fit, Nf; paper: 11 (VGA), 7 (QVGA). Higher -> smoother, blind to short pieces
  int min_line_points =
      0;  ///< [px] shortest segment, Nl; paper: 30 (VGA), 23 (QVGA). Higher -> fewer, surer candidates
  double line_fidelity = 4.0;  ///< [-] bound of the Mahalanobis distances of three adjacent windows. Higher
                               ///< -> bent pieces pass as straight
  double line_noise_factor =
      1.0;  ///< [-] noise along the scan as a multiple of Eq. 5. Higher -> coarser quantisation tolerated
};

/// Candidates by principal component analysis. 0 means: from the image's width.
struct CandidateParameters {
  int points_per_segment =
      1;  ///< [-] 1, 3 or 5 candidates for each segment. Higher -> slower, finds more small planes
  int normal_window =
      0;  ///< [px] side of the window of the PCA; paper: 20. Higher -> steadier normals, fewer near edges
  int min_window_points =
      0;  ///< [px] valid points that it needs, Ns; paper: 240. Higher -> no candidate near holes
  double max_curvature =
      0.05;  ///< [-] smallest eigenvalue over the sum. Higher -> rougher places may start a plane
};

/// Recursive extraction, Algorithm 2. 0 means: from the image's width.
struct ExtractionParameters {
  double plane_distance = 0.02;  ///< [m] a point's distance to its plane, delta_d. Higher -> thicker planes,
                                 ///< that swallow their neighbours
  double neighbor_distance =
      0.03;  ///< [m] between neighbours of one plane, delta_n. Higher -> bridges gaps and steps
  double distance_noise_factor = 3.8;  ///< [-] method adaptive: both distances are at least so many sigma_z
                                       ///< (Eq. 5). Higher -> far planes stay whole
  int min_plane_inliers =
      0;  ///< [px] smallest plane, N; paper: 5000 (VGA), 1000 (QVGA). Higher -> only large planes
  double min_plane_area = 0.0;  ///< [m²] smallest plane; 0 = no such limit. Higher -> only large planes
};

/// Method adaptive: the local planes at the crossings of the scanlines.
struct PatchParameters {
  double patch_noise_factor = 1.6;  ///< [-] tolerance of a patch, and unit of merge costs, as a multiple of
                                    ///< sigma_z. Higher -> coarser sensors, blunter edges
  double patch_distance =
      0.004;  ///< [m] least tolerance across the plane. Higher -> nearby surfaces may be rougher
  double patch_flatness = 1.2;  ///< [-] largest mean squared error of a patch, in tolerances squared. Higher
                                ///< -> rough and curved surfaces count as planes
};

/// Method adaptive: which patches make one plane.
struct ClusterParameters {
  double merge_cost = 4.4;     ///< [-] neighbours merge if that moves neither by more, in tolerances squared.
                               ///< Higher -> fewer, larger planes over blunt edges
  double coplanar_cost = 3.5;  ///< [-] the same for planes apart, with an object before the gap; 0 = never.
                               ///< Higher -> more is joined across gaps
  double max_curvedness = 1.0;  ///< [-] largest mean squared error of a small plane, in tolerances squared.
                                ///< Higher -> pieces of curved things, as people, count as planes
  double max_waviness = 0.25;   ///< [-] mean square that the patches of a small plane may deviate from it, in
                                ///< tolerances squared. Higher -> people and rough things count as planes
  double max_bend = 0.1;  ///< [-] mean square that a small plane may deviate as a curved surface would, in
                          ///< tolerances squared. Higher -> pieces of smooth curved things count as planes
  int min_patches = 3;    ///< [-] smallest plane in patches. Higher -> only large planes
};

/// Method adaptive: tidying the label image. 0 means: from the image's width.
struct CleanupParameters {
  int min_region_pixels =
      0;  ///< [px] smaller pieces and holes go to what surrounds them. Higher -> smoother regions
};

/// Outline polygons.
struct OutlineParameters {
  bool trace_outlines = true;  ///< polygons of the planes; off -> faster, empty outlines
  double outline_tolerance =
      2.0;  ///< [px] largest distance of the border to its polygon. Higher -> fewer vertices
  int min_hole_pixels = 100;  ///< [px] smaller holes are closed. Higher -> simpler polygons
};

/// All parameters of the method with their defaults: those of a Kinect or Xtion.
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

/// Calls `visitor(name, value, min, max)` for every parameter, `value` being a reference to an int,
/// double, bool or Method: the one list of the parameters' public names and bounds, which the command line,
/// dynamic_reconfigure and the tests go by.
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

/// Says that a parameter, by its public name, has no effect on a method. Empty if it has one.
std::string noEffect(const std::string& name, Method method);

/// Brings every parameter within its bounds, a NaN to its default, points_per_segment to 1, 3 or 5,
/// line_window from 1, which makes no line, to 2, and min_range below max_range.
/// @return one line for each value that was changed, which names it; empty if none was
std::vector<std::string> sanitize(Parameters& parameters);

/// Fills in every parameter that is 0 for "from the image's width": the paper's values at 640 and at
/// 320 pixels, between them interpolated, beyond them scaled so that the method looks at the same
/// part of the view.
/// @param width  [px], at least 1
Parameters resolve(const Parameters& parameters, int width);

/// The parameters of a preset: "kinect" (the defaults), "short_range" (scanners with millimetre steps
/// and small parts), "paper" (the published method to the letter).
/// @return false, and `parameters` unchanged, if there is no preset of that name
bool loadPreset(const std::string& name, Parameters& parameters);

/// Sets one parameter from text, "0.02", "true", "paper".
/// @return an empty string, or what is wrong with `name` or `value`
std::string setParameter(const std::string& name, const std::string& value, Parameters& parameters);

}  // namespace line_plane_segmentation
