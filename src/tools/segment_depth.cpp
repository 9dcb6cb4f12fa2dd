// SPDX-License-Identifier: BSD-3-Clause
#include <boost/program_options.hpp>
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
      "depth-scale", po::value<double>()->value_name("N"),
      "units of the depth images that make a metre, such as 1000 or 5000")(
      "units-per-metre", po::value<double>()->value_name("N"),
      "the same, by the name that it has in tables and results")(
      "dataset", po::value<std::string>()->value_name("NAME"),
      "FOLDER is a sequence of tum, icl_nuim, nyu or 7scenes, whose camera and depth scale are known")(
      "frames-csv", po::value<std::string>()->value_name("FILE"),
      "a table of frames in place of --camera, --depth-scale and IMAGE: columns frame, width, height, "
      "units_per_metre, fx, fy, cx, cy; the images are depth/FRAME.png beside it")(
      "out", po::value<std::string>()->value_name("DIR"), "folder for the results, made if it is not there")(
      "report", po::value<std::string>()->value_name("FILE.html"),
      "also make a page to look at, whole in this one file: overlays, planes, times")(
      "redo",
      "segment again what is finished: by default frames are passed over whose results are there, made with "
      "the same settings and not older than the image");
  shown.add_options()(
      "jobs", po::value<int>()->value_name("N")->default_value(0, ""),
      "work on N images at a time, by default one for each core; with 1 the times that are measured "
      "are not disturbed");
  addParameterOptions(shown);
  shown.add_options()("help", "this text")("version", "the version");
  return shown;
}

void printHelp() {
  std::cout
      << "Finds the planes in depth images, 16-bit PNGs with 0 where there is no depth, on all cores.\n\n"
         "  segment_depth --camera FX,FY,CX,CY --depth-scale UNITS_PER_METRE --out DIR [OPTION]... IMAGE...\n"
         "  segment_depth --camera FX,FY,CX,CY --depth-scale UNITS_PER_METRE --out DIR [OPTION]... FOLDER\n"
         "  segment_depth --dataset NAME --out DIR [OPTION]... FOLDER\n"
         "  segment_depth --frames-csv FILE --out DIR [OPTION]...\n\n"
         "For each image STEM.png it writes DIR/STEM.labels.png (16-bit, 0 = no plane), "
         "DIR/STEM.planes.json\n"
         "and DIR/STEM.overlay.png (to look at). Of a FOLDER it takes all PNGs, or those in its depth/. A "
         "run that\n"
         "was ended goes on where it was when it is started again.\n\n"
      << options() << '\n'
      << datasetHelp() << '\n'
      << parameterList();
}

po::variables_map parse(int argc, char** argv) {
  po::options_description all = options();
  all.add_options()("image", po::value<std::vector<std::string>>()->default_value({}, ""));
  po::positional_options_description positional;
  positional.add("image", -1);
  return parseOptions(argc, argv, all, positional);
}

// By either of its names.
std::optional<double> unitsPerMetre(const po::variables_map& given) {
  if (given.count("depth-scale") != 0 && given.count("units-per-metre") != 0) {
    throw BadInput("--depth-scale and --units-per-metre are the same; give one of them");
  }
  for (const char* name : {"depth-scale", "units-per-metre"}) {
    if (given.count(name) != 0) return given[name].as<double>();
  }
  return {};
}

std::vector<DepthFrame> framesOfTheDataset(const po::variables_map& given) {
  const auto& folders = given["image"].as<std::vector<std::string>>();
  if (folders.size() != 1) throw BadInput("--dataset takes one FOLDER, that of a sequence; see --help");
  std::optional<CameraIntrinsics> camera;
  if (given.count("camera") != 0) camera = parseCamera(given["camera"].as<std::string>());
  return framesOfDataset(given["dataset"].as<std::string>(), folders.front(), camera, unitsPerMetre(given));
}

std::vector<DepthFrame> framesOf(const po::variables_map& given) {
  const auto& images = given["image"].as<std::vector<std::string>>();
  if (given.count("frames-csv") != 0) {
    for (const char* other : {"camera", "depth-scale", "units-per-metre", "dataset"}) {
      if (given.count(other) == 0 && images.empty()) continue;
      throw BadInput(
          "--frames-csv takes the place of --camera, --depth-scale, --dataset and images; give one or the "
          "other");
    }
    return framesOfTable(given["frames-csv"].as<std::string>());
  }
  if (given.count("dataset") != 0) return framesOfTheDataset(given);
  const CameraIntrinsics camera = parseCamera(required(given, "camera").as<std::string>());
  const std::optional<double> units_per_metre = unitsPerMetre(given);
  if (!units_per_metre) required(given, "depth-scale");
  const bool folder = images.size() == 1 && fs::is_directory(images.front());
  return framesOfImages(folder ? imagesIn(images.front()) : images, camera, *units_per_metre);
}

void segmentDepth(int argc, char** argv) {
  const po::variables_map given = parse(argc, argv);
  if (given.count("help") != 0) return printHelp();
  DepthTask task;
  task.frames = framesOf(given);
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
