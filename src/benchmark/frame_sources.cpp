// SPDX-License-Identifier: BSD-3-Clause
#include "frame_sources.h"

#include <algorithm>
#include <cmath>

#include "depth_frames.h"
#include "run_tool.h"
#include "simulation.h"

namespace line_plane_segmentation {
namespace {

using simulation::kinectIntrinsics;

BenchmarkFrame emptyFrame(const std::string& name, int width, int height) {
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return {name, width, height, kinectIntrinsics(width, height), 0.001F, std::vector<std::uint16_t>(pixels)};
}

/// Cell of a grid over the image, on the plane z = 1, and the depth of its content. The contents of
/// neighbours have different depths, so that they form no common plane.
struct Cell {
  double x, y, width, height;
  double depth;  // [m]
};

std::vector<Cell> gridCells(int count, const CameraIntrinsics& camera, int width, int height) {
  const int columns = std::max(1, static_cast<int>(std::lround(std::sqrt(count * 4.0 / 3.0))));
  const int rows = (count + columns - 1) / columns;
  const double cell_width = width / camera.fx / columns;
  const double cell_height = height / camera.fy / rows;
  std::vector<Cell> cells;
  for (int i = 0; i < count; ++i) {
    const int column = i % columns;
    const int row = i / columns;
    cells.push_back({(column + 0.5) * cell_width - camera.cx / camera.fx,
                     (row + 0.5) * cell_height - camera.cy / camera.fy, cell_width, cell_height,
                     1.0 + 0.4 * (column % 2) + 0.2 * (row % 2)});
  }
  return cells;
}

// Roberts' R2 sequence: the tilts of any number of tiles are all different and fill their range evenly.
constexpr double kSpreadX = 0.7548776662466927;
constexpr double kSpreadY = 0.5698402909980532;

void addTile(const Cell& cell, int index, simulation::Scene& scene) {
  constexpr double kFill = 0.94;
  constexpr double kMostTilt = 0.45;
  const double side = 0.5 * kFill * cell.depth;
  const double slope_x = kMostTilt * std::remainder(2.0 * kSpreadX * index, 2.0);
  const double slope_y = kMostTilt * std::remainder(2.0 * kSpreadY * index, 2.0);
  const auto corner = [&](double u, double v) {
    const double x = u * side * cell.width;
    const double y = v * side * cell.height;
    return Eigen::Vector3d(cell.x * cell.depth + x, cell.y * cell.depth + y,
                           cell.depth + slope_x * x + slope_y * y);
  };
  scene.addPolygon({corner(-1, -1), corner(-1, 1), corner(1, 1), corner(1, -1)});
}

void addBall(const Cell& cell, simulation::Scene& scene) {
  const double radius = 0.45 * cell.depth * std::min(cell.width, cell.height);
  scene.addCurvedBody(simulation::ellipsoid(Eigen::Vector3d(cell.x, cell.y, 1.0) * cell.depth,
                                            Eigen::Vector3d::Constant(radius)));
}

}  // namespace

std::vector<BenchmarkFrame> recordedFrames(const std::filesystem::path& folder) {
  const std::vector<DepthFrame> listed = framesOfTable(folder / "frames.csv");
  checkNames(listed);
  std::vector<BenchmarkFrame> frames;
  for (const DepthFrame& from : listed) {
    const cv::Mat image = readDepth(from);
    if (image.depth() != CV_16U)
      throw BadInput(from.image.string() + ": is not an image of 16 bits, as the benchmark needs");
    BenchmarkFrame frame{from.name, image.cols, image.rows, from.camera, static_cast<float>(from.depth_unit),
                         {}};
    for (int v = 0; v < image.rows; ++v) {
      frame.depth.insert(frame.depth.end(), image.ptr<std::uint16_t>(v),
                         image.ptr<std::uint16_t>(v) + image.cols);
    }
    frames.push_back(std::move(frame));
  }
  return frames;
}

std::vector<BenchmarkFrame> simulatedRooms(int count, int width, int height) {
  std::vector<BenchmarkFrame> frames;
  for (int seed = 1; seed <= count; ++seed) {
    BenchmarkFrame frame = emptyFrame("room " + std::to_string(seed), width, height);
    simulation::SimulatedCamera camera({static_cast<std::uint64_t>(seed), width, height, true});
    camera.capture(0, 0.0, frame.depth.data());
    frames.push_back(std::move(frame));
  }
  return frames;
}

BenchmarkFrame simulatedTiles(int planes, int width, int height) {
  constexpr int kBalls = 48;
  BenchmarkFrame frame = emptyFrame(std::to_string(planes) + " planes", width, height);
  simulation::Scene scene;
  const std::vector<Cell> cells = gridCells(planes == 0 ? kBalls : planes, frame.camera, width, height);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (planes == 0) {
      addBall(cells[i], scene);
    } else {
      addTile(cells[i], static_cast<int>(i), scene);
    }
  }
  simulation::Rendering rendering;
  simulation::render(scene, Eigen::Isometry3d::Identity(), frame.camera, width, height, rendering);
  simulation::KinectNoise({}, 1).apply(rendering, frame.camera, 0, frame.depth.data());
  return frame;
}

BenchmarkFrame halved(const BenchmarkFrame& frame) {
  const CameraIntrinsics& camera = frame.camera;
  BenchmarkFrame half{frame.name,       frame.width / 2,
                      frame.height / 2, {camera.fx / 2, camera.fy / 2, camera.cx / 2, camera.cy / 2},
                      frame.depth_unit, {}};
  for (int v = 0; v < half.height; ++v) {
    for (int u = 0; u < half.width; ++u) {
      half.depth.push_back(
          frame.depth[static_cast<std::size_t>(2 * v) * static_cast<std::size_t>(frame.width) +
                      static_cast<std::size_t>(2 * u)]);
    }
  }
  return half;
}

}  // namespace line_plane_segmentation
