// SPDX-License-Identifier: BSD-3-Clause
#include "bag_output.h"

namespace line_plane_segmentation {

BagOutput::BagOutput(const std::filesystem::path& file, rosbag::CompressionType compression)
    : bag_(std::make_unique<rosbag::Bag>()) {
  guarded([&] {
    bag_->open(file.string(), rosbag::bagmode::Write);
    bag_->setCompression(compression);
  });
}

BagOutput::~BagOutput() {
  // ~Bag() closes the bag, which writes. On a full disk that throws out of the destructor and terminates
  // the program, so the object is not destroyed then.
  if (bag_ != nullptr && bag_->isOpen()) static_cast<void>(bag_.release());
}

void BagOutput::close() {
  guarded([&] { bag_->close(); });
}

}  // namespace line_plane_segmentation
