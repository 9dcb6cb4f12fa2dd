// SPDX-License-Identifier: BSD-3-Clause
#include "bag_output.h"

#include <cstring>
#include <utility>

namespace line_plane_segmentation {

BagOutput::BagOutput(const std::filesystem::path& file, std::string name, rosbag::CompressionType compression)
    : name_(std::move(name)), bag_(std::make_unique<rosbag::Bag>()) {
  guarded([&] {
    bag_->open(file.string(), rosbag::bagmode::Write);
    bag_->setCompression(compression);
  });
}

// ~Bag() closes the bag, which writes. On a full disk that throws out of the destructor and terminates the
// program, so an unfinished bag is not destroyed.
BagOutput::~BagOutput() {
  if (bag_ != nullptr && bag_->isOpen()) static_cast<void>(bag_.release());
}

void BagOutput::close() {
  guarded([&] { bag_->close(); });
}

void BagOutput::giveUp(const std::string& problem, int error) {
  static_cast<void>(bag_.release());
  throw BadInput(name_ + ": cannot be written, " +
                 (error == 0 ? problem : std::string(std::strerror(error)) + " (" + problem + ")"));
}

}  // namespace line_plane_segmentation
