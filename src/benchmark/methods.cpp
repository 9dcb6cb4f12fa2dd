// SPDX-License-Identifier: BSD-3-Clause
#include "methods.h"

#include <algorithm>

#include "line_primitive_engine.h"
#include "pcl_engines.h"

namespace line_plane_segmentation {
namespace {

std::unique_ptr<Engine> makePaperEngine(int points_per_segment) {
  Parameters parameters;
  loadPreset("paper", parameters);
  parameters.candidates.points_per_segment = points_per_segment;
  return makeLinePrimitiveEngine(parameters);
}

void addBaselines(const std::string& ending, std::unique_ptr<Engine> (*make)(PclMethod),
                  std::vector<BenchmarkMethod>& all) {
  all.push_back({"omps" + ending, false, make(PclMethod::kOmps)});
  all.push_back({"omps_refined" + ending, false, make(PclMethod::kOmpsRefined)});
  all.push_back({"ransac" + ending, true, make(PclMethod::kRansac)});
  std::unique_ptr<Engine> region_growing = make(PclMethod::kRegionGrowing);
  if (region_growing != nullptr) all.push_back({"rgs" + ending, true, std::move(region_growing)});
}

}  // namespace

std::vector<BenchmarkMethod> allMethods() {
  std::vector<BenchmarkMethod> all;
  all.push_back({"adaptive", false, makeLinePrimitiveEngine({})});
  all.push_back({"paper_1", false, makePaperEngine(1)});
  all.push_back({"paper_3", false, makePaperEngine(3)});
  all.push_back({"paper_5", false, makePaperEngine(5)});
  addBaselines("", makePclEngine, all);
#ifdef PCL_ENGINES_WITH_AVX2
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
    addBaselines("_avx2", makePclEngineWithAvx2, all);
  }
#endif
  return all;
}

std::vector<BenchmarkMethod> selectMethods(const std::vector<std::string>& names) {
  std::vector<BenchmarkMethod> chosen = allMethods();
  const auto is_other = [&names](const BenchmarkMethod& method) {
    return std::find(names.begin(), names.end(), method.name) == names.end();
  };
  chosen.erase(std::remove_if(chosen.begin(), chosen.end(), is_other), chosen.end());
  return chosen;
}

}  // namespace line_plane_segmentation
