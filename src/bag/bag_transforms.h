// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tf2/buffer_core.h>

#include <string>

#include "bag_input.h"
#include "transform_lookup.h"

namespace line_plane_segmentation {

/// Buffer of the transforms of a bag up to the current position.
class BagTransforms {
 public:
  /// Returns true if add() uses messages of this topic and type.
  static bool wants(const std::string& topic, const std::string& datatype);

  /// @throws std::exception if the message cannot be deserialised
  void add(const BagMessage& message);

  tf2::BufferCore& buffer() { return buffer_; }

 private:
  tf2::BufferCore buffer_;
  ClockJumpDetector jump_detector_;
};

}  // namespace line_plane_segmentation
