// SPDX-License-Identifier: BSD-3-Clause
// The time that ROS adds to the segmenter's own time within one process, as in a nodelet manager.
#include <ros/console.h>
#include <ros/master.h>
#include <ros/ros.h>

#include <algorithm>
#include <boost/function.hpp>
#include <boost/make_shared.hpp>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "command_line.h"
#include "frame_sources.h"
#include "machine.h"
#include "measurement.h"
#include "message_path.h"
#include "output_files.h"
#include "plane_segmenter_nodelet.h"
#include "report.h"
#include "report_program.h"
#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

namespace po = boost::program_options;

const std::vector<std::string> kAllOutputs = {"planes", "labels", "cloud", "overlay", "markers", "scanlines"};

po::options_description options() {
  po::options_description shown("Options");
  shown.add_options()("frames", po::value<std::string>()->value_name("DIR"),
                      "folder with a table frames.csv and the images depth/FRAME.png, as for "
                      "benchmark_segmentation; without it, simulated rooms")(
      "rooms", po::value<int>()->value_name("N")->default_value(4), "how many simulated rooms")(
      "repetitions", po::value<int>()->value_name("N")->default_value(50), "times that each frame is sent")(
      "out", po::value<std::string>()->value_name("DIR"), "folder for messages.md")("help", "this text")(
      "version", "the version");
  return shown;
}

/// The times of one frame, each sent again and again [ms].
struct Samples {
  int planes = 0;
  std::vector<double> segmenter, answered, all_answered;
  std::vector<double> ratio, all_ratio;  ///< to the segmenter's own time in the same round
};

// In a round each frame goes first to a segmenter whose planes alone are subscribed to, and then to one with
// all topics: a noisy minute of the machine hits both.
std::vector<Samples> measure(const std::vector<BenchmarkFrame>& frames, int repetitions) {
  const boost::function<boost::shared_ptr<nodelet::Nodelet>(const std::string&)> create =
      [](const std::string& /*type*/) { return boost::make_shared<PlaneSegmenterNodelet>(); };
  nodelet::Loader loader(create);
  MessagePath planes(loader, "planes_only", {"planes"});
  MessagePath all(loader, "all_topics", kAllOutputs);
  planes.connect(frames.front());
  all.connect(frames.front());

  std::vector<Samples> samples(frames.size());
  for (int round = -1; round < repetitions; ++round) {
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const MessageTimes alone = planes.send(frames[i]);
      const MessageTimes together = all.send(frames[i]);
      if (round < 0) continue;  // to warm up
      samples[i].planes = alone.planes;
      samples[i].segmenter.push_back(alone.segmenter);
      samples[i].answered.push_back(alone.answered);
      samples[i].ratio.push_back(alone.answered / alone.segmenter);
      samples[i].all_answered.push_back(together.answered);
      samples[i].all_ratio.push_back(together.answered / alone.segmenter);
    }
  }
  return samples;
}

std::string markdown(const std::vector<BenchmarkFrame>& frames, const std::vector<Samples>& samples) {
  nlohmann::json data{{"machine", describeProcessor()}, {"frames", nlohmann::json::array()}};
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Samples& s = samples[i];
    data["frames"].push_back({{"frame", frames[i].name},
                              {"width", frames[i].width},
                              {"height", frames[i].height},
                              {"planes", s.planes},
                              {"segmenter", toJson(statisticsOf(s.segmenter))},
                              {"answered", toJson(statisticsOf(s.answered))},
                              {"ratio", toJson(statisticsOf(s.ratio))},
                              {"all_answered", toJson(statisticsOf(s.all_answered))},
                              {"all_ratio", toJson(statisticsOf(s.all_ratio))}});
  }
  return makeReport("messages", data);
}

void benchmarkMessages(int argc, char** argv) {
  ros::init(argc, argv, "benchmark_messages", ros::init_options::AnonymousName | ros::init_options::NoRosout);
  // ROS would log to stdout, which is the reports.
  if (ros::console::set_logger_level(ROSCONSOLE_DEFAULT_NAME, ros::console::levels::Warn)) {
    ros::console::notifyLoggerLevelsChanged();
  }
  const po::variables_map given = parseOptions(argc, argv, options(), {});
  if (given.count("help") != 0) {
    std::cout
        << "Measures how much longer a frame takes from message to messages than in the segmenter alone, in "
           "this process. Needs a ROS master: scripts/run_benchmark --messages starts one.\n\n"
        << options();
    return;
  }
  const int rooms = given["rooms"].as<int>();
  const int repetitions = given["repetitions"].as<int>();
  if (rooms < 1 || rooms > 1000) throw BadInput("--rooms must be 1 to 1000");
  if (repetitions < 1 || repetitions > 100000) throw BadInput("--repetitions must be 1 to 100000");
  const std::vector<BenchmarkFrame> frames = given.count("frames") != 0
                                                 ? recordedFrames(given["frames"].as<std::string>())
                                                 : simulatedRooms(rooms, 640, 480);
  if (given.count("out") != 0) makeOutputFolder(given["out"].as<std::string>());
  if (!ros::master::check()) throw BadInput("no ROS master answers at " + ros::master::getURI());

  const ros::NodeHandle keeps_ros_running;
  const std::string report = markdown(frames, measure(frames, repetitions));
  std::cout << report;
  if (given.count("out") == 0) return;
  OutputFiles files;
  files.add(std::filesystem::path(given["out"].as<std::string>()) / "messages.md", report);
  files.commit();
}

}  // namespace
}  // namespace line_plane_segmentation

int main(int argc, char** argv) {
  using namespace line_plane_segmentation;
  return runTool("benchmark_messages", argc, argv, benchmarkMessages);
}
