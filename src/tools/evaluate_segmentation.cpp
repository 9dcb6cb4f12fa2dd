// SPDX-License-Identifier: BSD-3-Clause
#include <boost/program_options.hpp>
#include <iostream>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "command_line.h"
#include "curve_picture.h"
#include "evaluation.h"
#include "output_files.h"
#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

namespace po = boost::program_options;

po::options_description options() {
  po::options_description shown("Options");
  auto add = shown.add_options();
  add("truth", po::value<std::string>()->value_name("DIR"),
      "folder of truth images FRAME.png, 16-bit: 0 = no plane, 65535 = do not judge");
  add("labels", po::value<std::string>()->value_name("DIR"),
      "folder of FRAME.labels.png or FRAME.png, 16-bit: 0 = no plane");
  add("tolerance", po::value<double>()->value_name("T")->default_value(0.8, "0.8"),
      "mutual overlap of a correct region, above 0.5, at most 1");
  add("min-pixels", po::value<std::int64_t>()->value_name("N")->default_value(0),
      "truth regions with fewer pixels need not be found");
  add("json", po::value<std::string>()->value_name("FILE"), "write all figures, and the curve, to this file");
  add("curve", po::value<std::string>()->value_name("FILE.png"), "draw the classification over tolerances");
  add("help", "this text");
  add("version", "the version");
  return shown;
}

void printHelp() {
  std::cout
      << "Compares label images with truth images, frame by frame and as a set.\n\n"
         "  evaluate_segmentation --truth DIR --labels DIR [OPTION]...\n\n"
      << options()
      << "\n"
         "correct, over, under, missed, noise: regions by the classification of Hoover et al. (1996).\n"
         "1:1: truth regions with a label region of the mutual overlap of a correct one, even if pieces "
         "beside it\n"
         "     make it count as over-segmented.\n"
         "precision, recall, F1: regions with an IoU above 0.5 match.  mIoU: best IoU of each truth region.\n"
         "Label regions that lie mostly on pixels not to be judged count only if they hold half a truth "
         "region.\n"
         "PQ: F1 times the mean IoU of the matches.  covering: best IoU, weighted by pixels.\n";
}

EvaluationSettings settingsOf(const po::variables_map& given) {
  EvaluationSettings settings;
  settings.truth = required(given, "truth").as<std::string>();
  settings.labels = required(given, "labels").as<std::string>();
  settings.tolerance = given["tolerance"].as<double>();
  settings.min_pixels = given["min-pixels"].as<std::int64_t>();
  if (!(settings.tolerance > 0.5 && settings.tolerance <= 1.0)) {
    throw BadInput("the tolerance must be above 0.5 and at most 1");
  }
  if (settings.min_pixels < 0) throw BadInput("--min-pixels must not be negative");
  return settings;
}

std::vector<unsigned char> curvePng(const std::vector<EvaluatedFrame>& frames,
                                    const EvaluationSettings& settings) {
  const cv::Mat picture = drawCurve(toleranceCurve(frames, settings.min_pixels), settings.tolerance,
                                    scoreOf(frames, settings).hoover);
  std::vector<unsigned char> bytes;
  cv::imencode(".png", picture, bytes);
  return bytes;
}

void evaluateSegmentation(int argc, char** argv) {
  const po::variables_map given = parseOptions(argc, argv, options(), po::positional_options_description());
  if (given.count("help") != 0) return printHelp();
  const EvaluationSettings settings = settingsOf(given);
  const std::vector<EvaluatedFrame> frames = countFolders(settings.truth, settings.labels);

  OutputFiles files;
  if (given.count("json") != 0) files.add(given["json"].as<std::string>(), evaluationJson(frames, settings));
  if (given.count("curve") != 0) files.add(given["curve"].as<std::string>(), curvePng(frames, settings));
  files.commit();
  std::cout << evaluationTable(frames, settings);
}

}  // namespace
}  // namespace line_plane_segmentation

int main(int argc, char** argv) {
  using namespace line_plane_segmentation;
  return runTool("evaluate_segmentation", argc, argv, evaluateSegmentation);
}
