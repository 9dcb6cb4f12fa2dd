// SPDX-License-Identifier: BSD-3-Clause
#include "datasets.h"

#include <algorithm>
#include <boost/algorithm/string.hpp>
#include <cctype>
#include <fstream>

#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

namespace fs = std::filesystem;

struct Dataset {
  const char* name;
  double depth_unit;   // [m]
  const char* prefix;  // of the depth images, where there are other images beside them
  const char* suffix;
  bool largest_is_none;
  bool in_depth_folder;  // the images are in FOLDER/depth, other images in FOLDER
  const char* help;
};

constexpr Dataset kDatasets[] = {
    {"tum", 0.0002, "", ".png", false, false,
     "TUM RGB-D: FOLDER/depth/*.png; intrinsics by freiburg1, 2 or 3 in FOLDER's name"},
    {"icl_nuim", 0.0002, "", ".png", false, false, "ICL-NUIM in TUM's format: FOLDER/depth/*.png"},
    {"nyu", 0.001, "sync_depth_", ".png", false, false,
     "NYU Depth v2 as PNGs in the colour camera's view: FOLDER/sync_depth_*.png, FOLDER/*.png or "
     "FOLDER/depth/*.png"},
    {"7scenes", 0.001, "", ".depth.png", true, false, "7-Scenes: FOLDER/*.depth.png of one seq-NN"},
    {"scannet", 0.001, "", ".png", false, true,
     "ScanNet as its SensReader exports it: FOLDER/depth/*.png, FOLDER/intrinsic/intrinsic_depth.txt"},
};

// Intrinsics as published with each data set, of the camera in whose view the depth images are.
const CameraIntrinsics kFreiburg[] = {
    {517.3, 516.5, 318.6, 255.3}, {520.9, 521.0, 325.1, 249.7}, {535.4, 539.2, 320.1, 247.6}};

const Dataset& datasetOf(const std::string& name) {
  const auto found = std::find_if(std::begin(kDatasets), std::end(kDatasets),
                                  [&name](const Dataset& dataset) { return name == dataset.name; });
  if (found == std::end(kDatasets)) {
    throw BadInput("no data set is named '" + name + "'; there are " + datasetNames());
  }
  return *found;
}

// The folder's own name, also of "." and of one with a slash at its end.
std::string sequenceName(const fs::path& folder) {
  const fs::path whole = fs::weakly_canonical(folder / ".");
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

// A 4x4 matrix, row by row.
CameraIntrinsics cameraOfScanNet(const fs::path& folder) {
  for (const char* name : {"intrinsic/intrinsic_depth.txt", "intrinsic_depth.txt", "intrinsics_depth.txt"}) {
    const fs::path file = folder / name;
    if (!fs::exists(file)) continue;
    std::ifstream stream(file);
    double matrix[16];
    for (double& element : matrix) {
      if (!(stream >> element)) throw BadInput(file.string() + ": is not a matrix of 4 x 4 numbers");
    }
    const CameraIntrinsics camera{matrix[0], matrix[5], matrix[2], matrix[6]};
    if (!camera.isValid()) throw BadInput(file.string() + ": holds no valid intrinsics");
    return camera;
  }
  throw BadInput(folder.string() + ": there is no intrinsic/intrinsic_depth.txt; give --camera");
}

CameraIntrinsics cameraOf(const Dataset& dataset, const fs::path& folder) {
  const std::string name = dataset.name;
  if (name == "icl_nuim") return {481.2, 480.0, 319.5, 239.5};
  if (name == "nyu") return {518.85790117450188, 519.46961112127485, 325.58244941119034, 253.73616633400465};
  if (name == "7scenes") return {585.0, 585.0, 320.0, 240.0};
  if (name == "scannet") return cameraOfScanNet(folder);
  const std::string sequence = sequenceName(folder);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string number = std::to_string(i + 1);
    if (sequence.find("freiburg" + number) != std::string::npos ||
        sequence.find("fr" + number) != std::string::npos) {
      return kFreiburg[i];
    }
  }
  throw BadInput("which camera took '" + sequence +
                 "'? Its name has none of freiburg1, freiburg2 and freiburg3; give --camera");
}

bool isResult(const std::string& name) {
  return boost::ends_with(name, ".labels.png") || boost::ends_with(name, ".overlay.png");
}

bool isDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

// The digits that begin at `at`, without zeros in front; `at` moves behind them.
std::string takeNumber(const std::string& text, std::size_t& at) {
  while (at < text.size() && text[at] == '0') ++at;
  const std::size_t begin = at;
  while (at < text.size() && isDigit(text[at])) ++at;
  return text.substr(begin, at - begin);
}

// 2.png before 10.png.
bool comesBefore(const std::string& a, const std::string& b) {
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (isDigit(a[i]) && isDigit(b[j])) {
      const std::string x = takeNumber(a, i), y = takeNumber(b, j);
      if (x != y) return x.size() != y.size() ? x.size() < y.size() : x < y;
    } else {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i;
      ++j;
    }
  }
  return a.size() - i != b.size() - j ? a.size() - i < b.size() - j : a < b;
}

std::vector<std::string> imagesDirectlyIn(const fs::path& folder, const std::string& prefix,
                                          const std::string& suffix) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.front() == '.' || isResult(name)) continue;
    if (boost::starts_with(name, prefix) && boost::ends_with(name, suffix)) names.push_back(name);
  }
  std::sort(names.begin(), names.end(), comesBefore);
  for (std::string& name : names) name = (folder / name).string();
  return names;
}

std::vector<std::string> imagesIn(const fs::path& folder, const std::string& prefix,
                                  const std::string& suffix) {
  if (!fs::is_directory(folder)) throw BadInput(folder.string() + ": no such folder");
  std::vector<std::string> images = imagesDirectlyIn(folder, prefix, suffix);
  if (images.empty()) images = imagesDirectlyIn(folder, "", suffix);
  if (images.empty()) images = imagesDirectlyIn(folder / "depth", "", suffix);
  if (images.empty()) throw BadInput(folder.string() + ": there is no *" + suffix + ", nor in its depth/");
  return images;
}

}  // namespace

std::string datasetNames() { return "tum, icl_nuim, nyu, 7scenes and scannet"; }

std::string datasetHelp() {
  std::string text = "Data sets\n";
  for (const Dataset& dataset : kDatasets) {
    const std::string name = dataset.name;
    text += "  " + name + std::string(10 - name.size(), ' ') + dataset.help + "\n";
  }
  return text;
}

std::vector<std::string> imagesIn(const fs::path& folder) {
  if (!fs::is_directory(folder)) throw BadInput(folder.string() + ": no such folder");
  std::vector<std::string> images;
  for (const fs::path& place : {folder, folder / "depth"}) {
    for (const std::string& extension : depthFormats()) {
      if (images.empty()) images = imagesDirectlyIn(place, "", extension);
    }
  }
  if (images.empty()) throw BadInput(folder.string() + ": there is no *.png, nor in its depth/");
  return images;
}

std::vector<DepthFrame> framesOfDataset(const std::string& name, const fs::path& folder,
                                        const std::optional<CameraIntrinsics>& camera,
                                        const std::optional<double>& depth_unit) {
  const Dataset& dataset = datasetOf(name);
  const std::vector<std::string> images =
      imagesIn(dataset.in_depth_folder ? folder / "depth" : folder, dataset.prefix, dataset.suffix);
  std::vector<DepthFrame> frames = framesOfImages(images, camera ? *camera : cameraOf(dataset, folder),
                                                  depth_unit.value_or(dataset.depth_unit));
  const std::size_t beyond_stem = std::string(dataset.suffix).size() - std::string(".png").size();
  for (DepthFrame& frame : frames) {
    frame.name.resize(frame.name.size() - beyond_stem);
    frame.largest_is_none = dataset.largest_is_none;
  }
  return frames;
}

}  // namespace line_plane_segmentation
