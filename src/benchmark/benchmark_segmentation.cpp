// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <opencv2/imgcodecs.hpp>

#include "command_line.h"
#include "frame_sources.h"
#include "output_files.h"
#include "report.h"
#include "run_tool.h"
#include "scaling.h"
#include "segmentation_pictures.h"
#include "time_picture.h"

namespace line_plane_segmentation {
namespace {

namespace fs = std::filesystem;
namespace po = boost::program_options;

constexpr int kMostRooms = 1000;
constexpr int kMostRepetitions = 100000;

po::options_description options() {
  po::options_description shown("Options");
  shown.add_options()(
      "frames", po::value<std::string>()->value_name("DIR"),
      "folder with a table frames.csv (columns frame, width, height, units_per_metre, fx, fy, cx, "
      "cy) and the images depth/FRAME.png; without it, simulated rooms")(
      "rooms", po::value<int>()->value_name("N")->default_value(4), "how many simulated rooms")(
      "out", po::value<std::string>()->value_name("DIR"),
      "folder for benchmark.md, times.csv, stages.csv, scaling.csv, times.png")(
      "repetitions", po::value<int>()->value_name("N")->default_value(20),
      "runs of each method on each frame")(
      "slow-repetitions", po::value<int>()->value_name("N")->default_value(3), "the same for RANSAC and RGS")(
      "without", po::value<std::vector<std::string>>()->value_name("METHOD")->default_value({}, ""),
      "leaves a method out; may be given more than once")(
      "warm", "every timed run follows one of the same method on the same frame")(
      "pictures",
      "also writes what each method finds in each frame to DIR: FRAME.METHOD.png, and all of them "
      "beside each other, segmentations.png")(
      "no-scaling", "leaves out sizes, numbers of planes and cameras")("help", "this text")("version",
                                                                                            "the version");
  return shown;
}

std::vector<std::string> allNames() {
  std::vector<std::string> names;
  for (const Contestant& method : allContestants()) names.push_back(method.name);
  return names;
}

void printHelp() {
  std::cout << "Measures this method beside OMPS, RANSAC and region growing (RGS) from PCL, in one thread, "
               "in turn.\n\n"
               "  benchmark_segmentation [OPTION]...\n\n"
            << options() << "\nMethods:";
  for (const std::string& name : allNames()) std::cout << ' ' << name;
  std::cout << '\n';
}

int countOf(const po::variables_map& given, const std::string& option, int most) {
  const int count = given[option].as<int>();
  if (count < 1 || count > most) {
    throw BadInput("--" + option + " must be 1 to " + std::to_string(most) + ", not " +
                   std::to_string(count));
  }
  return count;
}

std::vector<std::string> methodsOf(const po::variables_map& given) {
  std::vector<std::string> names = allNames();
  for (const std::string& name : given["without"].as<std::vector<std::string>>()) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) throw BadInput("no method is named '" + name + "'; see --help");
    names.erase(found);
  }
  if (names.empty()) throw BadInput("every method is left out");
  return names;
}

/// The frames as they are, then at half the size.
std::vector<BenchmarkFrame> framesOf(const po::variables_map& given) {
  constexpr int kSmallest = 40;
  std::vector<BenchmarkFrame> frames = given.count("frames") != 0
                                           ? recordedFrames(given["frames"].as<std::string>())
                                           : simulatedRooms(countOf(given, "rooms", kMostRooms), 640, 480);
  for (const BenchmarkFrame& frame : frames) {
    if (std::min(frame.width, frame.height) < kSmallest)
      throw BadInput(frame.name + ": is too small to measure with");
  }
  const std::size_t count = frames.size();
  for (std::size_t i = 0; i < count; ++i) frames.push_back(halved(frames[i]));
  return frames;
}

std::vector<unsigned char> encodePng(const cv::Mat& image) {
  std::vector<unsigned char> bytes;
  cv::imencode(".png", image, bytes);
  return bytes;
}

void writeResults(const fs::path& folder, const BenchmarkResults& results, const std::string& report) {
  std::vector<Measurement> scaling = results.sizes;
  scaling.insert(scaling.end(), results.planes.begin(), results.planes.end());
  OutputFiles files;
  files.add(folder / "benchmark.md", report);
  files.add(folder / "times.csv", timesCsv(results.frames));
  files.add(folder / "stages.csv", stagesCsv(results.frames));
  files.add(folder / "scaling.csv", timesCsv(scaling));
  files.add(folder / "times.png", encodePng(drawTimes(results.frames)));
  files.commit();
}

// Of the frames at their full size.
void writePictures(const fs::path& folder, const std::vector<BenchmarkFrame>& frames,
                   const std::vector<Contestant>& methods) {
  const std::vector<BenchmarkFrame> full(frames.begin(),
                                         frames.begin() + static_cast<std::ptrdiff_t>(frames.size() / 2));
  const SegmentationPictures pictures = drawSegmentations(full, methods);
  OutputFiles files;
  for (const auto& [name, picture] : pictures.single) files.add(folder / (name + ".png"), encodePng(picture));
  files.add(folder / "segmentations.png", encodePng(pictures.sheet));
  files.commit();
}

void benchmarkSegmentation(int argc, char** argv) {
  const po::variables_map given = parseOptions(argc, argv, options(), {});
  if (given.count("help") != 0) return printHelp();
  const MeasurementOptions how{countOf(given, "repetitions", kMostRepetitions),
                               countOf(given, "slow-repetitions", kMostRepetitions),
                               given.count("warm") != 0};
  const std::vector<std::string> methods = methodsOf(given);
  const std::vector<BenchmarkFrame> frames = framesOf(given);
  if (given.count("pictures") != 0) required(given, "out");
  if (given.count("out") != 0) makeOutputFolder(given["out"].as<std::string>());

  BenchmarkResults results;
  const std::vector<Contestant> engines = contestants(methods);
  results.frames = measure(frames, engines, how);
  if (given.count("no-scaling") == 0) {
    results.sizes = measureSizes(how);
    results.planes = measurePlanes(how);
    results.cameras = measureCameras(how);
  }
  const std::string report = markdownReport(results);
  std::cout << report;
  if (given.count("out") != 0) writeResults(given["out"].as<std::string>(), results, report);
  if (given.count("pictures") != 0) writePictures(given["out"].as<std::string>(), frames, engines);
}

}  // namespace
}  // namespace line_plane_segmentation

int main(int argc, char** argv) {
  using namespace line_plane_segmentation;
  return runTool("benchmark_segmentation", argc, argv, benchmarkSegmentation);
}
