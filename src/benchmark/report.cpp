// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include <algorithm>
#include <set>
#include <sstream>

#include "machine.h"
#include "table.h"

namespace line_plane_segmentation {
namespace {

using Measurements = std::vector<Measurement>;

std::string sizeOf(const Measurement& m) { return std::to_string(m.width) + "x" + std::to_string(m.height); }

std::string frameOf(const Measurement& m) { return m.frame + ", " + sizeOf(m); }

std::string ratioText(const Measurements& all, const Measurement& m) {
  const double ratio = ratioToReference(all, m);
  return ratio > 0.0 ? threeDigits(ratio) : "-";
}

std::string medianText(const Measurement* m) { return m == nullptr ? "-" : threeDigits(m->total.median); }

// One measurement for each frame and size.
Measurements firstOfEachFrame(const Measurements& all) {
  Measurements firsts;
  for (const Measurement& m : all) {
    if (firsts.empty() || frameOf(firsts.back()) != frameOf(m)) firsts.push_back(m);
  }
  return firsts;
}

std::string stageTable(const Measurements& all) {
  Table::Row heading{"frame", "method"};
  for (int i = 0; i < kStageCount; ++i) heading.emplace_back(nameOf(static_cast<Stage>(i)));
  heading.emplace_back("total");
  Table table(heading);
  for (const Measurement& m : all) {
    if (m.stages.empty() || m.method == "paper_3" || m.method == "paper_5") continue;
    Table::Row row{frameOf(m), m.method};
    for (const Statistics& stage : m.stages) row.push_back(threeDigits(stage.median));
    row.push_back(threeDigits(m.total.median));
    table.add(row);
  }
  return table.markdown();
}

std::string medianTable(const Measurements& all, const std::vector<std::string>& methods) {
  Table::Row heading{"frame"};
  heading.insert(heading.end(), methods.begin(), methods.end());
  Table table(heading);
  for (const Measurement& frame : firstOfEachFrame(all)) {
    Table::Row row{frameOf(frame)};
    for (const std::string& method : methods) row.push_back(medianText(find(all, frame, method)));
    table.add(row);
  }
  return table.markdown();
}

Table methodTable(const Measurements& all) {
  Table table({"frame", "method", "median", "minimum", "maximum", "runs", "planes",
               std::string(kReferenceName) + " / it"});
  for (const Measurement& m : all) {
    table.add({frameOf(m), m.method, threeDigits(m.total.median), threeDigits(m.total.min),
               threeDigits(m.total.max), std::to_string(m.total.runs), std::to_string(m.planes),
               ratioText(all, m)});
  }
  return table;
}

// The worst frame's median over the median of all frames' medians.
std::string spreadTable(const Measurements& all) {
  Table table({"method", "size", "median of the frames", "worst frame", "ratio"});
  std::set<std::string> done;
  for (const Measurement& first : all) {
    if (!done.insert(first.method + sizeOf(first)).second) continue;
    std::vector<double> medians;
    for (const Measurement& m : all) {
      if (m.method == first.method && sizeOf(m) == sizeOf(first)) medians.push_back(m.total.median);
    }
    const Statistics set = statisticsOf(medians);
    table.add({first.method, sizeOf(first), threeDigits(set.median), threeDigits(set.max),
               threeDigits(set.max / set.median)});
  }
  return table.markdown();
}

std::string scalingTable(const Measurements& all, const std::string& unit,
                         double (*amount)(const Measurement&)) {
  Table table({"frame", "method", "median", "planes found", unit, std::string(kReferenceName) + " / it"});
  for (const Measurement& m : all) {
    table.add({frameOf(m), m.method, threeDigits(m.total.median), std::to_string(m.planes),
               threeDigits(m.total.median * 1e3 / amount(m)), ratioText(all, m)});
  }
  return table.markdown();
}

double kilopixels(const Measurement& m) { return m.width * static_cast<double>(m.height) * 1e-3; }

double planesOrOne(const Measurement& m) { return std::max(1, m.planes); }

std::string cameraTable(const std::vector<CameraLoad>& loads) {
  Table table({"cameras", "a frame of each", "for each camera", "rounds a second"});
  for (const CameraLoad& load : loads) {
    table.add({std::to_string(load.cameras), threeDigits(load.round.median),
               threeDigits(load.round.median / load.cameras), threeDigits(1e3 / load.round.median)});
  }
  return table.markdown();
}

}  // namespace

const Measurement* find(const Measurements& all, const Measurement& on_frame_of, const std::string& method) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Measurement& m) {
    return m.method == method && frameOf(m) == frameOf(on_frame_of);
  });
  return found == all.end() ? nullptr : &*found;
}

double ratioToReference(const Measurements& all, const Measurement& measurement) {
  const Measurement* reference = find(all, measurement, kReferenceName);
  return reference == nullptr ? 0.0 : reference->total.median / measurement.total.median;
}

std::string markdownReport(const BenchmarkResults& results) {
  std::ostringstream text;
  text << describeMachine() << "\nAll times in milliseconds, medians if not said otherwise.\n\n"
       << "### Stages (the paper's Table 1)\n\n"
       << stageTable(results.frames) << "\n### 1, 3 and 5 points a segment (Table 2)\n\n"
       << medianTable(results.frames, {"paper_1", "paper_3", "paper_5"}) << "\n### VGA and QVGA (Table 3)\n\n"
       << medianTable(results.frames, {"adaptive", "paper_1", "omps", "omps_refined"})
       << "\n### All methods (Table 4)\n\n"
       << methodTable(results.frames).markdown() << "\n### The worst frame\n\n"
       << spreadTable(results.frames);
  if (!results.sizes.empty()) {
    text << "\n### Size of the image\n\n" << scalingTable(results.sizes, "µs a kilopixel", kilopixels);
  }
  if (!results.planes.empty()) {
    text << "\n### Number of planes\n\n" << scalingTable(results.planes, "µs a plane found", planesOrOne);
  }
  if (!results.cameras.empty()) text << "\n### Cameras on one core\n\n" << cameraTable(results.cameras);
  return text.str();
}

std::string timesCsv(const Measurements& measurements) {
  Table table({"frame", "width", "height", "method", "median_ms", "min_ms", "max_ms", "runs", "planes",
               "omps_ratio"});
  for (const Measurement& m : measurements) {
    table.add({m.frame, std::to_string(m.width), std::to_string(m.height), m.method,
               std::to_string(m.total.median), std::to_string(m.total.min), std::to_string(m.total.max),
               std::to_string(m.total.runs), std::to_string(m.planes),
               std::to_string(ratioToReference(measurements, m))});
  }
  return table.csv();
}

std::string stagesCsv(const Measurements& measurements) {
  Table table({"frame", "width", "height", "method", "stage", "median_ms", "min_ms", "max_ms", "runs"});
  for (const Measurement& m : measurements) {
    for (std::size_t i = 0; i < m.stages.size(); ++i) {
      const Statistics& stage = m.stages[i];
      table.add({m.frame, std::to_string(m.width), std::to_string(m.height), m.method,
                 nameOf(static_cast<Stage>(i)), std::to_string(stage.median), std::to_string(stage.min),
                 std::to_string(stage.max), std::to_string(stage.runs)});
    }
  }
  return table.csv();
}

}  // namespace line_plane_segmentation
