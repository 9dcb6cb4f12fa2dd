// SPDX-License-Identifier: BSD-3-Clause
#include "depth_frames.h"

#include <algorithm>
#include <boost/algorithm/string.hpp>
#include <boost/lexical_cast/try_lexical_convert.hpp>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <set>

#include "image_file.h"
#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

using Row = std::vector<std::string>;

double parseNumber(const std::string& text) {
  double number = 0.0;
  if (!boost::conversion::try_lexical_convert(text, number)) throw BadInput("'" + text + "' is no number");
  return number;
}

void checkDepthUnit(double depth_unit) {
  const auto used = static_cast<float>(depth_unit);
  if (!(used > 0.0F && std::isfinite(used))) {
    throw BadInput("the depth unit must be a positive number, such as --depth-unit 0.001");
  }
}

// Cells of a CSV line (RFC 4180). Boost's escaped_list_separator drops "" within quotes.
Row splitRow(std::string line) {
  if (!line.empty() && line.back() == '\r') line.pop_back();
  Row cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool is_quote = line[i] == '"';
    if (quoted && is_quote && i + 1 < line.size() && line[i + 1] == '"') {
      cells.back() += line[++i];
    } else if (is_quote && (quoted || cells.back().empty())) {
      quoted = !quoted;
    } else if (line[i] == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += line[i];
    }
  }
  if (quoted) throw BadInput("a quote is not closed");
  return cells;
}

void dropByteOrderMark(std::string& line) {
  if (line.rfind("\xEF\xBB\xBF", 0) == 0) line.erase(0, 3);
}

// The cells of one row by the names of their columns.
class NamedRow {
 public:
  NamedRow(const Row& columns, const Row& cells) {
    for (std::size_t i = 0; i < std::min(columns.size(), cells.size()); ++i) cells_[columns[i]] = cells[i];
  }
  bool has(const std::string& column) const { return cells_.count(column) != 0; }
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

// The first that exists; FRAME.png if none does.
std::filesystem::path imageOf(const std::string& name, const std::filesystem::path& folder) {
  for (const std::string& extension : depthFormats()) {
    if (std::filesystem::exists(folder / (name + extension))) return folder / (name + extension);
  }
  return folder / (name + ".png");
}

DepthFrame frameOfRow(const NamedRow& row, const std::filesystem::path& folder) {
  DepthFrame frame;
  frame.name = row.text("frame");
  if (frame.name.empty() || frame.name.find('/') != std::string::npos) {
    throw BadInput("'" + frame.name + "' is no name of a frame");
  }
  frame.image = imageOf(frame.name, folder / "depth");
  frame.camera = {row.number("fx"), row.number("fy"), row.number("cx"), row.number("cy")};
  if (!frame.camera.isValid()) throw BadInput("the focal lengths must be positive");
  frame.depth_unit = row.has("depth_unit") ? row.number("depth_unit") : 1.0 / row.number("units_per_metre");
  checkDepthUnit(frame.depth_unit);
  frame.width = row.pixels("width");
  frame.height = row.pixels("height");
  return frame;
}

std::string sizeText(int width, int height) { return std::to_string(width) + " x " + std::to_string(height); }

}  // namespace

const std::vector<std::string>& depthFormats() {
  static const std::vector<std::string> kFormats{".png", ".npy", ".tiff", ".tif", ".exr", ".pgm"};
  return kFormats;
}

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
                                       double depth_unit) {
  checkDepthUnit(depth_unit);
  std::vector<DepthFrame> frames;
  for (const std::filesystem::path image : images) {
    frames.push_back({image.stem().string(), image, camera, depth_unit, 0, 0, false, kDefaultMaxPixels});
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
    dropByteOrderMark(line);
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

cv::Mat decodeDepth(const std::vector<unsigned char>& bytes, const DepthFrame& frame) {
  cv::Mat image = decodeDepth(bytes, frame.image, frame.max_pixels);
  const bool any_size = frame.width == 0;
  if (!any_size && (image.cols != frame.width || image.rows != frame.height)) {
    throw BadInput(frame.image.string() + ": is " + sizeText(image.cols, image.rows) + " pixels, not " +
                   sizeText(frame.width, frame.height) + " as its table says");
  }
  if (frame.largest_is_none && image.depth() == CV_16U) {
    image.setTo(0, image == std::numeric_limits<std::uint16_t>::max());
  }
  return image;
}

DepthView depthViewOf(const cv::Mat& depth, double depth_unit) {
  DepthView view;
  view.data = depth.data;
  view.width = depth.cols;
  view.height = depth.rows;
  view.step = depth.step;
  view.type = depth.depth() == CV_16U ? DepthType::kUint16 : DepthType::kFloat32;
  view.depth_unit = static_cast<float>(depth_unit);
  return view;
}

cv::Mat readDepth(const DepthFrame& frame) { return decodeDepth(readFile(frame.image), frame); }

}  // namespace line_plane_segmentation
