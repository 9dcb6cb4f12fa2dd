// SPDX-License-Identifier: BSD-3-Clause
#include <console_bridge/console.h>

#include <iostream>
#include <map>

#include "bag_task.h"
#include "command_line.h"
#include "depth_frames.h"
#include "input_options.h"
#include "location_options.h"
#include "output_files.h"
#include "parameter_options.h"
#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

namespace fs = std::filesystem;
namespace po = boost::program_options;

po::options_description options() {
  po::options_description shown("Options");
  shown.add_options()("topic",
                      po::value<std::vector<std::string>>()->value_name("TOPIC")->default_value({}, ""),
                      "a depth image topic, plain or compressed; may be given more than once; without it, "
                      "every topic of 16UC1 or "
                      "32FC1 images, and of mono16 ones if its name says depth")(
      "info-topic", po::value<std::vector<std::string>>()->value_name("TOPIC")->default_value({}, ""),
      "its camera_info, where that is not beside the images: once for all, or once for each --topic")(
      "camera", po::value<std::string>()->value_name("FX,FY,CX,CY"),
      "the intrinsics, for a bag without camera_info")("labels", "write the label images, too")(
      "cloud", "write the coloured clouds, too (large)")("overlay", "write the overlay pictures, too")(
      "markers", "write the markers for rviz, too")("scanlines",
                                                    "write the line segments and candidates for rviz, too")(
      "input", "copy every message of IN.bag, too")("all", "all of these")(
      "csv", po::value<std::string>()->value_name("FILE"), "also write a table, a row for each plane")(
      "compression", po::value<std::string>()->value_name("NAME")->default_value("lz4"),
      "of OUT.bag: lz4, bz2 or none");
  addParameterOptions(shown);
  shown.add_options()("help", "this text")("version", "the version");
  return shown;
}

void printHelp() {
  std::cout << "Segments the depth images of a bag, on all cores, as the plane_segmenter does while it is "
               "played.\n\n"
               "  rosrun line_plane_segmentation segment_bag [OPTION]... IN.bag OUT.bag\n\n"
               "For the images of /camera/depth/image_raw it writes /camera/plane_segmenter/planes and, "
               "where asked "
               "for,\nlabels, cloud, overlay, markers and scanlines, each with the stamp of its image. A "
               "second depth "
               "topic of "
               "the same\ncamera, say /camera/depth/image_rect, has "
               "/camera/depth/image_rect/plane_segmenter/planes. "
               "OUT.bag appears\nwhen all is done. Of a bag that was cut off, all that is whole is done, and "
               "the exit "
               "code is 1.\n\n"
            << options() << '\n'
            << parameterList() << '\n'
            << locationParameterList() << '\n'
            << inputParameterList();
}

rosbag::CompressionType compressionOf(const po::variables_map& given) {
  const std::map<std::string, rosbag::CompressionType> kinds{{"lz4", rosbag::compression::LZ4},
                                                             {"bz2", rosbag::compression::BZ2},
                                                             {"none", rosbag::compression::Uncompressed}};
  const auto& name = given["compression"].as<std::string>();
  const auto found = kinds.find(name);
  if (found == kinds.end())
    throw BadInput("no compression is named '" + name + "'; there are lz4, bz2 and none");
  return found->second;
}

std::vector<std::string> topicNames(const po::variables_map& given, const std::string& option) {
  auto topics = given[option].as<std::vector<std::string>>();
  for (std::string& topic : topics) {
    if (topic.empty() || topic.front() != '/') topic.insert(0, "/");
  }
  return topics;
}

TopicChoice topicsOf(const po::variables_map& given) {
  TopicChoice topics;
  topics.images = topicNames(given, "topic");
  topics.infos = topicNames(given, "info-topic");
  if (topics.infos.size() > 1 && topics.infos.size() != topics.images.size()) {
    throw BadInput("give --info-topic once, or as often as --topic");
  }
  if (given.count("camera") != 0) {
    topics.camera = parseCamera(given["camera"].as<std::string>());
    if (!topics.infos.empty()) throw BadInput("--camera takes the place of --info-topic: give one of them");
  }
  return topics;
}

BagTask taskOf(const po::variables_map& given) {
  const auto& bags = given["bag"].as<std::vector<std::string>>();
  if (bags.size() != 2) throw BadInput("give two bags, IN.bag and OUT.bag; see --help");
  BagTask task;
  task.in = bags[0];
  task.out = bags[1];
  if (given.count("csv") != 0) task.csv = given["csv"].as<std::string>();
  task.topics = topicsOf(given);
  task.parameters = parametersOf(given, [&task](const std::string& name, const std::string& value) {
    return setInputParameter(name, value, task) || setLocationParameter(name, value, task.location);
  });
  const bool all = given.count("all") != 0;
  task.labels = all || given.count("labels") != 0;
  task.cloud = all || given.count("cloud") != 0;
  task.overlay = all || given.count("overlay") != 0;
  task.markers = all || given.count("markers") != 0;
  task.scanlines = all || given.count("scanlines") != 0;
  task.input = all || given.count("input") != 0;
  task.compression = compressionOf(given);
  return task;
}

void checkFiles(const BagTask& task) {
  const auto same = [](const fs::path& a, const fs::path& b) {
    return !a.empty() && wholePath(a) == wholePath(b);
  };
  if (isStream(task.out)) throw BadInput(task.out.string() + ": a bag can only be written to a file");
  if (same(task.out, task.in)) throw BadInput(task.out.string() + ": would overwrite IN.bag");
  if (same(task.csv, task.in) || same(task.csv, task.out)) {
    throw BadInput(task.csv.string() + ": the table would overwrite a bag");
  }
}

void segmentBagTool(int argc, char** argv) {
  po::options_description all = options();
  all.add_options()("bag", po::value<std::vector<std::string>>()->default_value({}, ""));
  po::positional_options_description positional;
  positional.add("bag", -1);
  const po::variables_map given = parseOptions(argc, argv, all, positional);
  if (given.count("help") != 0) return printHelp();
  const BagTask task = taskOf(given);
  checkFiles(task);
  // Suppresses rosbag's own output about broken chunks, which is repeated for each message.
  console_bridge::noOutputHandler();
  segmentBag(task);
}

}  // namespace
}  // namespace line_plane_segmentation

int main(int argc, char** argv) {
  using namespace line_plane_segmentation;
  return runTool("segment_bag", argc, argv, segmentBagTool);
}
