// SPDX-License-Identifier: BSD-3-Clause
#include <boost/program_options.hpp>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <opencv2/imgcodecs.hpp>
#include <set>
#include <string>
#include <vector>

#include "command_line.h"
#include "depth_frames.h"
#include "line_plane_segmentation/parameters.h"
#include "line_plane_segmentation/plane_segmenter.h"
#include "line_plane_segmentation/stage_clock.h"
#include "output_files.h"
#include "overlay.h"
#include "parameter_options.h"
#include "planes_json.h"
#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

namespace fs = std::filesystem;
namespace po = boost::program_options;

struct Task {
  std::vector<DepthFrame> frames;
  Parameters parameters;
  fs::path out;
};

po::options_description options() {
  po::options_description shown("Options");
  shown.add_options()("camera", po::value<std::string>()->value_name("FX,FY,CX,CY"),
                      "focal lengths and optical centre [px]")(
      "depth-scale", po::value<double>()->value_name("N"),
      "units of the depth images that make a metre, such as 1000 or 5000")(
      "frames-csv", po::value<std::string>()->value_name("FILE"),
      "a table of frames in place of --camera, --depth-scale and IMAGE: columns frame, width, height, "
      "units_per_metre, "
      "fx, fy, cx, cy; the images are depth/FRAME.png beside it")(
      "out", po::value<std::string>()->value_name("DIR"), "folder for the results, made if it is not there");
  addParameterOptions(shown);
  shown.add_options()("help", "this text");
  return shown;
}

void printHelp() {
  std::cout
      << "Finds the planes in depth images, 16-bit PNGs with 0 where there is no depth.\n\n"
         "  segment_depth --camera FX,FY,CX,CY --depth-scale UNITS_PER_METRE --out DIR [OPTION]... IMAGE...\n"
         "  segment_depth --frames-csv FILE --out DIR [OPTION]...\n\n"
         "For each image STEM.png it writes DIR/STEM.labels.png (16-bit, 0 = no plane), "
         "DIR/STEM.planes.json\n"
         "and DIR/STEM.overlay.png (to look at).\n\n"
      << options() << '\n'
      << parameterList();
}

po::variables_map parse(int argc, char** argv) {
  po::options_description all = options();
  all.add_options()("image", po::value<std::vector<std::string>>()->default_value({}, ""));
  po::positional_options_description positional;
  positional.add("image", -1);
  return parseOptions(argc, argv, all, positional);
}

std::vector<DepthFrame> framesOf(const po::variables_map& given) {
  const auto& images = given["image"].as<std::vector<std::string>>();
  if (given.count("frames-csv") == 0) {
    const CameraIntrinsics camera = parseCamera(required(given, "camera").as<std::string>());
    return framesOfImages(images, camera, required(given, "depth-scale").as<double>());
  }
  if (!images.empty() || given.count("camera") != 0 || given.count("depth-scale") != 0) {
    throw BadInput(
        "--frames-csv takes the place of --camera, --depth-scale and images; give one or the other");
  }
  return framesOfTable(given["frames-csv"].as<std::string>());
}

fs::path resultFile(const Task& task, const DepthFrame& frame, const std::string& ending) {
  return task.out / (frame.name + ending);
}

// Everything that can be wrong with the input shows here, before anything is written.
void checkInput(const Task& task) {
  checkNames(task.frames);
  std::set<fs::path> results;
  for (const DepthFrame& frame : task.frames) {
    for (const char* ending : {".labels.png", ".planes.json", ".overlay.png"}) {
      results.insert(fs::weakly_canonical(resultFile(task, frame, ending)));
    }
  }
  for (const DepthFrame& frame : task.frames) {
    readDepth(frame);
    if (results.count(fs::weakly_canonical(frame.image)) != 0) {
      throw BadInput(frame.image.string() + ": would be overwritten by a result; choose another --out");
    }
  }
}

std::vector<unsigned char> encodePng(const cv::Mat& image) {
  std::vector<unsigned char> bytes;
  cv::imencode(".png", image, bytes);
  return bytes;
}

DepthView viewOf(const cv::Mat& depth, double units_per_metre) {
  DepthView view;
  view.data = depth.data;
  view.width = depth.cols;
  view.height = depth.rows;
  view.step = depth.step;
  view.type = DepthType::kUint16;
  view.metres_per_unit = static_cast<float>(1.0 / units_per_metre);
  return view;
}

void writeResults(const Task& task, const DepthFrame& frame, const cv::Mat& depth, Segmentation segmentation,
                  const StageClock& clock) {
  const cv::Mat labels(segmentation.height, segmentation.width, CV_16UC1, segmentation.labels.data());
  OutputFiles files;
  files.add(resultFile(task, frame, ".labels.png"), encodePng(labels));
  files.add(resultFile(task, frame, ".planes.json"), planesJson(frame.name, segmentation, clock));
  files.add(resultFile(task, frame, ".overlay.png"),
            encodePng(drawOverlay(depth, segmentation, frame.camera)));
  files.commit();
}

void printSummary(const DepthFrame& frame, const Segmentation& segmentation, const StageClock& clock) {
  const double share =
      segmentation.valid_pixels == 0 ? 0.0 : 100.0 * segmentation.assigned_pixels / segmentation.valid_pixels;
  std::printf("%s: %zu planes, %.0f %% of the depth, %.2f ms\n", frame.name.c_str(),
              segmentation.planes.size(), share, clock.totalMilliseconds());
}

void run(const Task& task) {
  PlaneSegmenter segmenter(task.parameters);
  for (const DepthFrame& frame : task.frames) {
    const cv::Mat depth = readDepth(frame);
    StageClock clock;
    const Segmentation& segmentation =
        segmenter.segment(viewOf(depth, frame.units_per_metre), frame.camera, &clock);
    writeResults(task, frame, depth, segmentation, clock);
    printSummary(frame, segmentation, clock);
  }
}

void segmentDepth(int argc, char** argv) {
  const po::variables_map given = parse(argc, argv);
  if (given.count("help") != 0) return printHelp();
  const Task task{framesOf(given), parametersOf(given), required(given, "out").as<std::string>()};
  checkInput(task);
  makeOutputFolder(task.out);
  run(task);
}

}  // namespace
}  // namespace line_plane_segmentation

int main(int argc, char** argv) {
  using namespace line_plane_segmentation;
  return runTool("segment_depth", [=] { segmentDepth(argc, argv); });
}
