// SPDX-License-Identifier: BSD-3-Clause
#include <boost/program_options.hpp>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "command_line.h"
#include "datasets.h"
#include "depth_frames.h"
#include "depth_task.h"
#include "interruption.h"
#include "parameter_options.h"
#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

namespace fs = std::filesystem;
namespace po = boost::program_options;

constexpr int kMostJobs = 1024;

po::options_description options() {
  po::options_description shown("Options");
  shown.add_options()("camera", po::value<std::string>()->value_name("FX,FY,CX,CY"),
                      "focal lengths and optical centre [px]")(
      "depth-unit", po::value<double>()->value_name("M"),
      "depth of one count of the images [m]: 0.001 for millimetres, 0.0002 for TUM, 1 for metres; accepted, "
      "too: the counts per metre as --units-per-metre or --depth-scale")(
      "dataset", po::value<std::string>()->value_name("NAME"),
      "FOLDER is a sequence of tum, icl_nuim, nyu, 7scenes or scannet, "
      "whose camera and depth units are known")(
      "frames-csv", po::value<std::string>()->value_name("FILE"),
      "a table of frames in place of --camera, --depth-unit and IMAGE: columns frame, width, height, "
      "depth_unit or units_per_metre, fx, fy, cx, cy; the images are depth/FRAME.png beside it")(
      "out", po::value<std::string>()->value_name("DIR"), "folder for the results, made if it is not there")(
      "report", po::value<std::string>()->value_name("FILE.html"),
      "also make an HTML page with overlays, planes and times, complete in this one file")(
      "redo",
      "segment all frames again and replace results of other images; by default frames are skipped whose "
      "results "
      "are complete, made from the same image with the same settings and version, and not older than the "
      "image");
  shown.add_options()("jobs", po::value<int>()->value_name("N")->default_value(0, ""),
                      "number of images processed at a time, by default one per core; with 1 the measured "
                      "times are not disturbed "
                      "by other images")("shard", po::value<std::string>()->value_name("I/N"),
                                         "process only every N-th image, beginning with the I-th, 1 to N: "
                                         "for N processes or machines at a time")(
      "max-pixels", po::value<std::int64_t>()->value_name("N")->default_value(kDefaultMaxPixels),
      "refuse larger images");
  addParameterOptions(shown);
  shown.add_options()("help", "this text")("version", "the version");
  return shown;
}

void printHelp() {
  std::cout
      << "Segments the planes of depth images on all cores. Images are 16-bit PNG, TIFF or PGM, 32-bit float "
         "TIFF or\n"
         "EXR, or NumPy arrays (.npy); 0 and NaN are invalid depth.\n\n"
         "  rosrun line_plane_segmentation segment_depth --camera FX,FY,CX,CY --depth-unit M --out DIR "
         "[OPTION]... IMAGE...|FOLDER\n"
         "  rosrun line_plane_segmentation segment_depth --dataset NAME --out DIR [OPTION]... FOLDER\n"
         "  rosrun line_plane_segmentation segment_depth --frames-csv FILE --out DIR [OPTION]...\n\n"
         "For each image STEM.png it writes DIR/STEM.labels.png (16-bit, 0 = no plane), DIR/STEM.planes.json "
         "and\n"
         "DIR/STEM.overlay.png. Of a FOLDER it takes all PNGs, or those in its depth/; without PNGs, all "
         "images of "
         "another format.\n"
         "An interrupted run continues when it is started again. planes.json records the image's path, size "
         "and "
         "SHA-256,\nthe version and the parameters.\n\n"
      << options() << '\n'
      << datasetHelp() << '\n'
      << parameterList();
}

// The options that give the depth unit. The older names, in counts per metre, are accepted but not shown.
std::vector<std::string> unitOptions(const po::variables_map& given) {
  std::vector<std::string> names;
  for (const char* name : {"depth-unit", "units-per-metre", "depth-scale"}) {
    if (given.count(name) != 0) names.emplace_back(name);
  }
  return names;
}

bool hasUnits(const po::variables_map& given) { return !unitOptions(given).empty(); }

double depthUnit(const po::variables_map& given) {
  const std::vector<std::string> names = unitOptions(given);
  if (names.size() > 1) {
    throw BadInput("--" + names[0] + " and --" + names[1] + " are the same; give one of them");
  }
  const double value = required(given, names.empty() ? "depth-unit" : names[0]).as<double>();
  return names[0] == "depth-unit" ? value : 1.0 / value;
}

po::variables_map parse(int argc, char** argv) {
  po::options_description all = options();
  all.add_options()("image", po::value<std::vector<std::string>>()->default_value({}, ""))(
      "units-per-metre", po::value<double>())("depth-scale", po::value<double>());
  po::positional_options_description positional;
  positional.add("image", -1);
  return parseOptions(argc, argv, all, positional);
}

std::vector<DepthFrame> framesOfTheDataset(const po::variables_map& given) {
  const auto& folders = given["image"].as<std::vector<std::string>>();
  if (folders.size() != 1) throw BadInput("--dataset takes one FOLDER, that of a sequence; see --help");
  std::optional<CameraIntrinsics> camera;
  if (given.count("camera") != 0) camera = parseCamera(given["camera"].as<std::string>());
  std::optional<double> depth_unit;
  if (hasUnits(given)) depth_unit = depthUnit(given);
  return framesOfDataset(given["dataset"].as<std::string>(), folders.front(), camera, depth_unit);
}

std::vector<DepthFrame> framesOf(const po::variables_map& given) {
  const auto& images = given["image"].as<std::vector<std::string>>();
  if (given.count("frames-csv") != 0) {
    if (given.count("camera") != 0 || given.count("dataset") != 0 || hasUnits(given) || !images.empty()) {
      throw BadInput(
          "--frames-csv takes the place of --camera, --depth-unit, --dataset and images; give one or "
          "the other");
    }
    return framesOfTable(given["frames-csv"].as<std::string>());
  }
  if (given.count("dataset") != 0) return framesOfTheDataset(given);
  const CameraIntrinsics camera = parseCamera(required(given, "camera").as<std::string>());
  const double depth_unit = depthUnit(given);
  const bool folder = images.size() == 1 && fs::is_directory(images.front());
  return framesOfImages(folder ? imagesIn(images.front()) : images, camera, depth_unit);
}

// Every N-th frame, beginning with the I-th.
std::vector<DepthFrame> shardOf(const std::vector<DepthFrame>& frames, const std::string& text) {
  std::size_t first = 0, count = 0;
  int end = 0;
  if (std::sscanf(text.c_str(), "%zu/%zu%n", &first, &count, &end) != 2 ||
      text.size() != static_cast<std::size_t>(end) || text.find('-') != std::string::npos || first < 1 ||
      first > count) {
    throw BadInput("--shard takes I/N with I from 1 to N, such as 1/4, not '" + text + "'");
  }
  std::vector<DepthFrame> shard;
  for (std::size_t i = first - 1; i < frames.size(); i += count) shard.push_back(frames[i]);
  return shard;
}

void segmentDepth(int argc, char** argv) {
  const po::variables_map given = parse(argc, argv);
  if (given.count("help") != 0) return printHelp();
  DepthTask task;
  task.frames = framesOf(given);
  checkNames(task.frames);
  if (given.count("shard") != 0) task.frames = shardOf(task.frames, given["shard"].as<std::string>());
  for (DepthFrame& frame : task.frames) frame.max_pixels = given["max-pixels"].as<std::int64_t>();
  if (given.count("frames-csv") != 0) task.table = given["frames-csv"].as<std::string>();
  task.parameters = parametersOf(given);
  task.out = required(given, "out").as<std::string>();
  if (given.count("report") != 0) task.report = given["report"].as<std::string>();
  task.redo = given.count("redo") != 0;
  task.jobs = given["jobs"].as<int>();
  if (task.jobs < 0 || task.jobs > kMostJobs)
    throw BadInput("--jobs must be 1 to " + std::to_string(kMostJobs));
  catchInterruption();
  segmentDepthImages(task);
}

}  // namespace
}  // namespace line_plane_segmentation

int main(int argc, char** argv) {
  using namespace line_plane_segmentation;
  return runTool("segment_depth", argc, argv, segmentDepth);
}
