// SPDX-License-Identifier: BSD-3-Clause
#include "labelled_set.h"

#include "depth_frames.h"
#include "image_file.h"
#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

bool isSelected(std::size_t index, Half half) {
  return half == Half::kBoth || (index % 2 == 1) == (half == Half::kOdd);
}

}  // namespace

std::vector<LabelledFrame> readLabelledSet(const std::filesystem::path& folder, Half half) {
  const std::vector<DepthFrame> table = framesOfTable(folder / "frames.csv");
  std::vector<LabelledFrame> frames;
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (!isSelected(i, half)) continue;
    const DepthFrame& frame = table[i];
    const std::filesystem::path truth_file = folder / "truth" / (frame.name + ".png");
    frames.push_back({frame.name, readDepth(frame), readImage16(truth_file), frame.camera, frame.depth_unit});
    if (frames.back().depth.size() != frames.back().truth.size()) {
      throw BadInput(truth_file.string() + ": differs in size from " + frame.image.string());
    }
  }
  if (frames.empty()) throw BadInput((folder / "frames.csv").string() + ": no frame is selected");
  return frames;
}

}  // namespace line_plane_segmentation
