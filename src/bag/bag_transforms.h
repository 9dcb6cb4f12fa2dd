// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tf2/buffer_core.h>

#include <string>

#include "bag_input.h"

namespace line_plane_segmentation {

/// The transforms of a bag up to where it was read.
class BagTransforms {
 public:
  /// If messages of this kind are of use to add().
  static bool wants(const std::string& topic, const std::string& datatype);

  /// @throws std::exception if the message is broken
  void add(const BagMessage& message);

  tf2::BufferCore& buffer() { return buffer_; }

 private:
  tf2::BufferCore buffer_;
};

}  // namespace line_plane_segmentation
