// SPDX-License-Identifier: BSD-3-Clause
#include "depth_frames.h"

#include <algorithm>
#include <boost/algorithm/string.hpp>
#include <boost/lexical_cast/try_lexical_convert.hpp>
#include <boost/tokenizer.hpp>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <set>

#include "image16.h"
#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

using Row = std::vector<std::string>;

double parseNumber(const std::string& text) {
  double number = 0.0;
  if (!boost::conversion::try_lexical_convert(text, number)) throw BadInput("'" + text + "' is no number");
  return number;
}

void checkScale(double units_per_metre) {
  const auto metres_per_unit = static_cast<float>(1.0 / units_per_metre);
  if (!(metres_per_unit > 0.0F && std::isfinite(metres_per_unit))) {
    throw BadInput("the depth scale must be a positive number, the units of a metre, such as 1000");
  }
}

// Commas separate, double quotes keep commas.
Row splitRow(std::string line) {
  if (!line.empty() && line.back() == '\r') line.pop_back();
  const boost::escaped_list_separator<char> commas("", ",", "\"");
  const boost::tokenizer<boost::escaped_list_separator<char>> cells(line, commas);
  return {cells.begin(), cells.end()};
}

// The cells of one row by the names of their columns.
class NamedRow {
 public:
  NamedRow(const Row& columns, const Row& cells) {
    for (std::size_t i = 0; i < std::min(columns.size(), cells.size()); ++i) cells_[columns[i]] = cells[i];
  }
  const std::string& text(const std::string& column) const {
    const auto cell = cells_.find(column);
    if (cell == cells_.end()) throw BadInput("has no column '" + column + "'");
    return cell->second;
  }
  double number(const std::string& column) const { return parseNumber(text(column)); }
  int pixels(const std::string& column) const {
    int count = 0;
    if (!boost::conversion::try_lexical_convert(text(column), count) || count < 1) {
      throw BadInput("'" + text(column) + "' is no " + column + " of an image");
    }
    return count;
  }

 private:
  std::map<std::string, std::string> cells_;
};

DepthFrame frameOfRow(const NamedRow& row, const std::filesystem::path& folder) {
  DepthFrame frame;
  frame.name = row.text("frame");
  if (frame.name.empty() || frame.name.find('/') != std::string::npos) {
    throw BadInput("'" + frame.name + "' is no name of a frame");
  }
  frame.image = folder / "depth" / (frame.name + ".png");
  frame.camera = {row.number("fx"), row.number("fy"), row.number("cx"), row.number("cy")};
  if (!frame.camera.isValid()) throw BadInput("the focal lengths must be positive");
  frame.units_per_metre = row.number("units_per_metre");
  checkScale(frame.units_per_metre);
  frame.width = row.pixels("width");
  frame.height = row.pixels("height");
  return frame;
}

std::string sizeText(int width, int height) { return std::to_string(width) + " x " + std::to_string(height); }

}  // namespace

CameraIntrinsics parseCamera(const std::string& text) {
  std::vector<std::string> parts;
  boost::split(parts, text, boost::is_any_of(","));
  const std::string problem =
      "the camera must be FX,FY,CX,CY in pixels, such as 525,525,319.5,239.5, not '" + text + "'";
  if (parts.size() != 4) throw BadInput(problem);
  std::vector<double> numbers(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!boost::conversion::try_lexical_convert(parts[i], numbers[i])) throw BadInput(problem);
  }
  const CameraIntrinsics camera{numbers[0], numbers[1], numbers[2], numbers[3]};
  if (!camera.isValid())
    throw BadInput("the camera's focal lengths must be positive, its numbers finite: '" + text + "'");
  return camera;
}

std::vector<DepthFrame> framesOfImages(const std::vector<std::string>& images, const CameraIntrinsics& camera,
                                       double units_per_metre) {
  checkScale(units_per_metre);
  std::vector<DepthFrame> frames;
  for (const std::filesystem::path image : images) {
    frames.push_back({image.stem().string(), image, camera, units_per_metre, 0, 0, false});
  }
  return frames;
}

std::vector<DepthFrame> framesOfTable(const std::filesystem::path& table) {
  std::ifstream stream(table);
  std::string line;
  if (!std::filesystem::is_regular_file(table) || !std::getline(stream, line)) {
    throw BadInput(table.string() + ": cannot be read");
  }
  std::vector<DepthFrame> frames;
  int line_number = 1;
  try {
    const Row columns = splitRow(line);
    for (++line_number; std::getline(stream, line); ++line_number) {
      if (boost::trim_copy(line).empty()) continue;
      frames.push_back(frameOfRow(NamedRow(columns, splitRow(line)), table.parent_path()));
    }
  } catch (const std::exception& error) {
    throw BadInput(table.string() + ", line " + std::to_string(line_number) + ": " + error.what());
  }
  return frames;
}

void checkNames(const std::vector<DepthFrame>& frames) {
  if (frames.empty()) throw BadInput("no image to segment; see --help");
  std::set<std::string> names;
  for (const DepthFrame& frame : frames) {
    if (!names.insert(frame.name).second) {
      throw BadInput("two images are named '" + frame.name + "', their results would overwrite each other");
    }
  }
}

cv::Mat readDepth(const DepthFrame& frame) {
  cv::Mat image = readImage16(frame.image);
  const bool any_size = frame.width == 0;
  if (!any_size && (image.cols != frame.width || image.rows != frame.height)) {
    throw BadInput(frame.image.string() + ": is " + sizeText(image.cols, image.rows) + " pixels, not " +
                   sizeText(frame.width, frame.height) + " as its table says");
  }
  if (frame.largest_is_none) image.setTo(0, image == std::numeric_limits<std::uint16_t>::max());
  return image;
}

}  // namespace line_plane_segmentation
