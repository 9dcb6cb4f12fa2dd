// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "command_line.h"
#include "frame_sources.h"
#include "output_files.h"
#include "report.h"
#include "report_program.h"
#include "run_tool.h"
#include "scaling.h"
#include "segmentation_pictures.h"

namespace line_plane_segmentation {
namespace {

namespace fs = std::filesystem;
namespace po = boost::program_options;

constexpr int kMostRooms = 1000;
constexpr int kMostRepetitions = 100000;

po::options_description options() {
  po::options_description shown("Options");
  shown.add_options()("frames", po::value<std::string>()->value_name("DIR"),
                      "folder with a table frames.csv (columns frame, width, height, depth_unit, fx, fy, cx, "
                      "cy) and the images depth/FRAME.png; without it, simulated rooms")(
      "rooms", po::value<int>()->value_name("N")->default_value(4), "how many simulated rooms")(
      "out", po::value<std::string>()->value_name("DIR"),
      "folder for benchmark.md, times.csv, stages.csv, scaling.csv, times.png")(
      "repetitions", po::value<int>()->value_name("N")->default_value(20),
      "runs of each method on each frame")(
      "slow-repetitions", po::value<int>()->value_name("N")->default_value(3), "the same for RANSAC and RGS")(
      "without", po::value<std::vector<std::string>>()->value_name("METHOD")->default_value({}, ""),
      "leaves a method out; may be given more than once")(
      "warm",
      "times of the stages and of the tables are those of warm runs, each directly after one of the same "
      "method on the "
      "same frame; without it, of cold runs, after other methods and frames. Both are measured")(
      "pictures",
      "also writes what each method finds in each frame to DIR: FRAME.METHOD.png, and all of them "
      "beside each other, segmentations.png")(
      "no-scaling", "leaves out sizes, numbers of planes and cameras")("help", "this text")("version",
                                                                                            "the version");
  return shown;
}

std::vector<std::string> allNames() {
  std::vector<std::string> names;
  for (const BenchmarkMethod& method : allMethods()) names.push_back(method.name);
  return names;
}

void printHelp() {
  std::cout << "Measures this method beside OMPS, RANSAC and region growing (RGS) from PCL, in one thread, "
               "in turn.\n\n"
               "  rosrun line_plane_segmentation benchmark_segmentation [OPTION]...\n\n"
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

void writeResults(const fs::path& folder, const BenchmarkResults& results, const std::string& report) {
  const nlohmann::json data = reportData(results);
  OutputFiles files;
  files.add(folder / "benchmark.md", report);
  files.add(folder / "times.csv", makeReport("times_csv", data));
  files.add(folder / "stages.csv", makeReport("stages_csv", data));
  files.add(folder / "scaling.csv", makeReport("times_csv", scalingData(results)));
  files.add(folder / "times.png", makeReport("times", data));
  files.commit();
}

// Frames at their full size.
std::vector<BenchmarkFrame> fullSize(const std::vector<BenchmarkFrame>& frames) {
  return {frames.begin(), frames.begin() + static_cast<std::ptrdiff_t>(frames.size() / 2)};
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
  const std::vector<BenchmarkMethod> engines = selectMethods(methods);
  results.frames = measure(frames, engines, how);
  if (given.count("no-scaling") == 0) {
    results.sizes = measureSizes(how);
    results.planes = measurePlanes(how);
    results.cameras = measureCameras(how);
  }
  const std::string report = makeReport("markdown", reportData(results));
  std::cout << report;
  if (given.count("out") != 0) writeResults(given["out"].as<std::string>(), results, report);
  if (given.count("pictures") != 0) {
    writeSegmentationPictures(given["out"].as<std::string>(), fullSize(frames), engines);
  }
}

}  // namespace
}  // namespace line_plane_segmentation

int main(int argc, char** argv) {
  using namespace line_plane_segmentation;
  return runTool("benchmark_segmentation", argc, argv, benchmarkSegmentation);
}
