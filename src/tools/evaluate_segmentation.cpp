// SPDX-License-Identifier: BSD-3-Clause
#include <boost/program_options.hpp>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "command_line.h"
#include "evaluation.h"
#include "labelled_set.h"
#include "line_primitive_segmenter.h"
#include "output_files.h"
#include "parameter_options.h"
#include "report_program.h"
#include "robust_report.h"
#include "run_tool.h"
#include "sensitivity.h"

namespace line_plane_segmentation {
namespace {

namespace po = boost::program_options;

po::options_description commonOptions() {
  po::options_description options("Options");
  auto add = options.add_options();
  add("tolerance", po::value<double>()->value_name("T")->default_value(0.8, "0.8"),
      "mutual overlap of a correct region, above 0.5, at most 1");
  add("min-pixels", po::value<std::int64_t>()->value_name("N")->default_value(0),
      "truth regions with fewer pixels need not be found");
  add("json", po::value<std::string>()->value_name("FILE"), "write all figures to this file");
  add("help", "this text");
  add("version", "the version");
  return options;
}

po::options_description labelOptions() {
  po::options_description options("Label images");
  auto add = options.add_options();
  add("truth", po::value<std::string>()->value_name("DIR"),
      "folder of truth images FRAME.png, 16-bit: 0 = no plane, 65535 = do not judge");
  add("labels", po::value<std::string>()->value_name("DIR"),
      "folder of FRAME.labels.png or FRAME.png, 16-bit: 0 = no plane");
  add("curve", po::value<std::string>()->value_name("FILE.png"), "draw the classification over tolerances");
  return options;
}

po::options_description robustOptions() {
  po::options_description options("Robust mode");
  auto add = options.add_options();
  add("robust", po::value<std::vector<std::string>>()->value_name("DIR")->composing(),
      "folder of a labelled set: frames.csv, depth/FRAME.png, truth/FRAME.png; may be given more than once");
  add("half", po::value<std::string>()->value_name("odd|even"),
      "only the frames with an odd or even index in frames.csv, which starts at 0");
  add("sensitivity",
      "table of the figures with each parameter at 0.7, 0.85, 1.2 and 1.4 of its default; exit code 1 if a "
      "default stands out, more than 0.015 above the mean of its two neighbours in any figure of any set");
  addParameterOptions(options);
  return options;
}

void printHelp() {
  std::cout
      << "Compares label images with truth images, frame by frame and as a set.\n"
         "Or segments labelled sets in many variants and reports the mean and the spread of each figure.\n\n"
         "  rosrun line_plane_segmentation evaluate_segmentation --truth DIR --labels DIR [OPTION]...\n"
         "  rosrun line_plane_segmentation evaluate_segmentation --robust DIR... [OPTION]...\n\n"
      << labelOptions() << "\n"
      << robustOptions() << "\n"
      << commonOptions()
      << "\n"
         "correct, over, under, missed, noise: regions by the classification of Hoover et al. (1996).\n"
         "1:1: truth regions with a label region of the mutual overlap of a correct one, even if pieces "
         "beside it\n"
         "     make it count as over-segmented.\n"
         "precision, recall, F1: regions with an IoU above 0.5 match.  mIoU: best IoU of each truth region.\n"
         "Label regions that lie mostly on pixels not to be judged count only if they hold half a truth "
         "region.\n"
         "PQ: F1 times the mean IoU of the matches.  covering: best IoU, weighted by pixels.\n"
         "Robust mode: every frame upright, mirrored, turned by 90 and by 180 degrees, each with scanline "
         "spacings of\n"
         "10 to 14 twelfths of the default and with two grid phases.\n"
         "flips: fraction of the truth regions that are found (IoU above 0.5) in some variants, but not in "
         "all.\n"
         "20-80 %: fraction of those that are found in at least 20 and at most 80 % of the variants.\n"
         "clutter: fraction of the pixels with depth, but without a plane in the ground truth, that lie in "
         "planes.\n";
}

EvaluationSettings settingsOf(const po::variables_map& given) {
  EvaluationSettings settings;
  settings.tolerance = given["tolerance"].as<double>();
  settings.min_pixels = given["min-pixels"].as<std::int64_t>();
  if (!(settings.tolerance > 0.5 && settings.tolerance <= 1.0)) {
    throw BadInput("the tolerance must be above 0.5 and at most 1");
  }
  if (settings.min_pixels < 0) throw BadInput("--min-pixels must not be negative");
  return settings;
}

// Neither an image of the ground truth nor one of the labels may be overwritten.
void protectInputs(const std::vector<EvaluatedFrame>& frames, const EvaluationSettings& settings,
                   OutputFiles& files) {
  for (const EvaluatedFrame& frame : frames) {
    files.protect(settings.truth / (frame.name + ".png"));
    files.protect(settings.labels / (frame.name + ".labels.png"));
    files.protect(settings.labels / (frame.name + ".png"));
  }
}

void evaluateLabels(const po::variables_map& given) {
  EvaluationSettings settings = settingsOf(given);
  settings.truth = required(given, "truth").as<std::string>();
  settings.labels = required(given, "labels").as<std::string>();
  const std::vector<EvaluatedFrame> frames = countFolders(settings.truth, settings.labels);

  OutputFiles files;
  protectInputs(frames, settings, files);
  const std::string figures = evaluationJson(frames, settings);
  if (given.count("json") != 0) files.add(given["json"].as<std::string>(), figures);
  if (given.count("curve") != 0) {
    files.add(given["curve"].as<std::string>(), makeReport("curve", nlohmann::json::parse(figures)));
  }
  files.commit();
  std::cout << evaluationTable(frames, settings);
}

Half halfOf(const po::variables_map& given) {
  if (given.count("half") == 0) return Half::kBoth;
  const auto& half = given["half"].as<std::string>();
  if (half != "odd" && half != "even") throw BadInput("--half takes odd or even, not '" + half + "'");
  return half == "odd" ? Half::kOdd : Half::kEven;
}

std::vector<NamedSet> readSets(const po::variables_map& given) {
  std::vector<NamedSet> sets;
  for (const std::string& folder : given["robust"].as<std::vector<std::string>>()) {
    const std::string name = wholePath(folder).filename().string();
    sets.push_back({name, readLabelledSet(folder, halfOf(given))});
  }
  return sets;
}

void addJson(const po::variables_map& given, const nlohmann::json& document, OutputFiles& files) {
  if (given.count("json") == 0) return;
  const auto replace = nlohmann::json::error_handler_t::replace;
  files.add(given["json"].as<std::string>(), document.dump(1, ' ', false, replace) + "\n");
}

void evaluateSets(const po::variables_map& given) {
  const EvaluationSettings settings = settingsOf(given);
  const Parameters parameters = parametersOf(given);
  std::vector<NamedRobustScores> scores;
  for (const NamedSet& set : readSets(given)) {
    const auto make_segmenter = [&] { return std::make_unique<LinePrimitiveSegmenter>(parameters); };
    scores.push_back({set.name, evaluateRobustly(set.frames, allVariants(), make_segmenter, settings)});
  }
  OutputFiles files;
  addJson(given, robustJson(scores, settings), files);
  files.commit();
  std::cout << robustTable(scores, settings);
}

void checkSensitivity(const po::variables_map& given) {
  const std::vector<NamedSet> sets = readSets(given);
  const auto sensitivity = evaluateSensitivity(sets, parametersOf(given), allVariants(), settingsOf(given));
  OutputFiles files;
  addJson(given, sensitivityJson(sets, sensitivity), files);
  files.commit();
  std::cout << sensitivityTable(sets, sensitivity);
  const std::string standing_out = namesThatStandOut(sensitivity);
  if (!standing_out.empty()) throw BadInput("defaults that stand out: " + standing_out);
}

void evaluateSegmentation(int argc, char** argv) {
  po::options_description options;
  options.add(labelOptions()).add(robustOptions()).add(commonOptions());
  const po::variables_map given = parseOptions(argc, argv, options, po::positional_options_description());
  if (given.count("help") != 0) return printHelp();
  if (given.count("robust") == 0) return evaluateLabels(given);
  given.count("sensitivity") != 0 ? checkSensitivity(given) : evaluateSets(given);
}

}  // namespace
}  // namespace line_plane_segmentation

int main(int argc, char** argv) {
  using namespace line_plane_segmentation;
  return runTool("evaluate_segmentation", argc, argv, evaluateSegmentation);
}
