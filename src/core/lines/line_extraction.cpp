// SPDX-License-Identifier: BSD-3-Clause
#include "lines/line_extraction.h"

#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <cmath>

namespace line_plane_segmentation {
namespace {

constexpr double kPi = 3.14159265358979323846;

// Two segments that overlap are one line if (alpha, r) agree: the 95 % bound of chi² with two degrees of
// freedom.
constexpr double kSameLine = 5.99;

double wrapAngle(double angle) {
  if (angle > kPi) return angle - 2.0 * kPi;
  if (angle <= -kPi) return angle + 2.0 * kPi;
  return angle;
}

Eigen::Matrix2d covarianceOf(const LineFit& line) {
  const double determinant =
      line.information_aa * line.information_rr - line.information_ar * line.information_ar;
  Eigen::Matrix2d covariance;
  covariance << line.information_rr, -line.information_ar, -line.information_ar, line.information_aa;
  return covariance / determinant;
}

// How a line lies to another one, seen from the middle of the other one's points. Their (alpha, r) about the
// camera are not to be compared: a metre away, a turn by the 0.1 rad that noise gives a window moves r by
// five millimetres, ten times what its covariance, a linear thing, allows. Near the points there is no such
// lever.
struct RelativeLine {
  double alpha, r;  // turn, and distance from that middle
  double t;         // place of that middle along this line
};

double middleOf(const LineFit& line) { return -line.information_ar / line.information_rr; }

RelativeLine seenFromMiddleOf(const LineFit& reference, const LineFit& line) {
  const double middle = middleOf(reference);
  const double alpha = wrapAngle(line.alpha - reference.alpha);
  const double cosine = std::cos(alpha), sine = std::sin(alpha);
  return {alpha, line.r - reference.r * cosine - middle * sine, middle * cosine - reference.r * sine};
}

// The same line, its r counted from place `t` along it.
LineFit withOriginAt(double t, LineFit line) {
  line.information_aa += t * (2.0 * line.information_ar + t * line.information_rr);
  line.information_ar += t * line.information_rr;
  return line;
}

bool isSameLine(const LineFit& a, const LineFit& b) {
  const RelativeLine relative = seenFromMiddleOf(a, b);
  const Eigen::Vector2d difference(relative.alpha, relative.r);
  const Eigen::Matrix2d covariance =
      covarianceOf(withOriginAt(middleOf(a), a)) + covarianceOf(withOriginAt(relative.t, b));
  return difference.dot(covariance.inverse() * difference) < kSameLine;
}

}  // namespace

LineFit fitLine(const ScanPoint* points, int count, const NoiseParameters& noise, double noise_factor) {
  assert(count >= 2);
  double x_mean = 0.0, y_mean = 0.0, z_mean = 0.0;
  for (int i = 0; i < count; ++i) {
    x_mean += points[i].x;
    y_mean += points[i].y;
    z_mean += points[i].z;
  }
  x_mean /= count;
  y_mean /= count;
  z_mean /= count;
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (int i = 0; i < count; ++i) {
    const double x = points[i].x - x_mean, y = points[i].y - y_mean;
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }

  LineFit line;
  line.alpha = 0.5 * std::atan2(-2.0 * xy, yy - xx);
  const double cosine = std::cos(line.alpha), sine = std::sin(line.alpha);
  line.r = x_mean * cosine + y_mean * sine;

  // A residual is e = Sx cos(alpha) + Sy sin(alpha) - r; its derivatives are t (the position along the line)
  // and -1. A point moves by sigma_z along its ray, and so by sigma_z * r / z across the line.
  double t_mean = y_mean * cosine - x_mean * sine;
  const double t_scatter = xx * sine * sine - 2.0 * xy * sine * cosine + yy * cosine * cosine;
  if (line.r < 0.0) {
    line.r = -line.r;
    line.alpha = wrapAngle(line.alpha + kPi);
    t_mean = -t_mean;
  }
  const double grazing_floor = 0.05;  // seen edge-on, the pixels' width takes over from the depth's noise
  const double sigma = noise_factor * noise.sigma(z_mean) * std::max(line.r / z_mean, grazing_floor);
  const double weight = 1.0 / (sigma * sigma);
  line.information_aa = weight * (t_scatter + count * t_mean * t_mean);
  line.information_ar = -weight * count * t_mean;
  line.information_rr = weight * count;
  return line;
}

double mahalanobis(const LineFit& line, const LineFit& other) {
  const RelativeLine relative = seenFromMiddleOf(line, other);
  const double information_alpha = line.information_aa + line.information_ar * middleOf(line);
  return information_alpha * relative.alpha * relative.alpha + line.information_rr * relative.r * relative.r;
}

const std::vector<double>& LineExtractor::fidelity(const ScanPoint* points, int count,
                                                   const NoiseParameters& noise,
                                                   const LineParameters& parameters) {
  const int window_count = count - parameters.line_window + 1;
  fidelity_.clear();
  if (window_count < 3) return fidelity_;
  windows_.clear();
  for (int i = 0; i < window_count; ++i) {
    windows_.push_back(fitLine(points + i, parameters.line_window, noise, parameters.line_noise_factor));
  }
  fidelity_.resize(static_cast<std::size_t>(window_count));
  for (std::size_t i = 1; i + 1 < windows_.size(); ++i) {
    fidelity_[i] = mahalanobis(windows_[i], windows_[i - 1]) + mahalanobis(windows_[i], windows_[i + 1]);
  }
  fidelity_.front() = fidelity_[1];
  fidelity_.back() = fidelity_[fidelity_.size() - 2];
  return fidelity_;
}

void LineExtractor::extractPiece(const Scanline& scanline, int first, int last, const NoiseParameters& noise,
                                 const LineParameters& parameters) {
  const ScanPoint* points = scanline.points.data();
  fidelity(points + first, last - first + 1, noise, parameters);

  const std::size_t ranges_before = ranges_.size();
  const int window_count = static_cast<int>(fidelity_.size());
  for (int i = 0; i < window_count;) {
    // Not ">=", which no NaN is: the loop would stay there for ever.
    if (!(fidelity_[i] < parameters.line_fidelity)) {
      ++i;
      continue;
    }
    const int run_first = i;
    while (i < window_count && fidelity_[i] < parameters.line_fidelity) ++i;
    Range range{first + run_first, first + i - 1 + parameters.line_window - 1, {}};
    range.line =
        fitLine(points + range.first, range.last - range.first + 1, noise, parameters.line_noise_factor);

    if (ranges_.size() > ranges_before) {
      Range& previous = ranges_.back();
      if (range.first <= previous.last && isSameLine(previous.line, range.line)) {
        previous.last = range.last;
        previous.line = fitLine(points + previous.first, previous.last - previous.first + 1, noise,
                                parameters.line_noise_factor);
        continue;
      }
    }
    ranges_.push_back(range);
  }
}

void LineExtractor::extract(const Scanline& scanline, const NoiseParameters& noise,
                            const LineParameters& parameters, std::vector<LineSegment>& segments) {
  ranges_.clear();
  const int count = static_cast<int>(scanline.points.size());
  for (int first = 0, i = 1; i <= count; ++i) {
    // A hole starts a new piece; a few missing pixels, fewer than a window, do not.
    const bool is_hole =
        i < count && scanline.points[i].pixel - scanline.points[i - 1].pixel > parameters.line_window;
    if (i < count && !is_hole) continue;
    if (i - first >= parameters.min_line_points) extractPiece(scanline, first, i - 1, noise, parameters);
    first = i;
  }
  for (const Range& range : ranges_) {
    if (range.last - range.first + 1 < parameters.min_line_points) continue;
    LineSegment segment;
    segment.direction = scanline.direction;
    segment.scanline = scanline.index;
    segment.first = scanline.points[range.first].pixel;
    segment.last = scanline.points[range.last].pixel;
    segment.points = range.last - range.first + 1;
    segment.alpha = range.line.alpha;
    segment.r = range.line.r;
    segment.covariance = covarianceOf(range.line);
    segments.push_back(segment);
  }
}

void LineExtractor::extract(const DepthImage& depth, const CameraIntrinsics& camera,
                            const Parameters& parameters, std::vector<LineSegment>& segments) {
  segments.clear();
  const int spacing = parameters.scanlines.scanline_spacing;
  for (const ScanDirection direction : {ScanDirection::kRow, ScanDirection::kColumn}) {
    const int count = scanlineCount(direction == ScanDirection::kRow ? depth.height : depth.width, spacing);
    for (int k = 1; k <= count; ++k) {
      projectScanline(depth, camera, direction, k * spacing, scanline_);
      extract(scanline_, parameters.noise, parameters.lines, segments);
    }
  }
}

}  // namespace line_plane_segmentation
