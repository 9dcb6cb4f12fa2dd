// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/header.h>
#include <rosbag/constants.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace line_plane_segmentation {

/// Largest accepted sizes of a record's header and of an uncompressed chunk [bytes].
constexpr std::uint32_t kLargestRecordHeader = 1U << 20;
constexpr std::uint32_t kLargestChunk = 1U << 30;

/// Reads an unaligned little-endian number.
inline std::uint32_t numberAt(const std::uint8_t* bytes) {
  return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8 | static_cast<std::uint32_t>(bytes[2]) << 16 |
         static_cast<std::uint32_t>(bytes[3]) << 24;
}

/// Header fields of a bag's record (wiki.ros.org/Bags/Format/2.0).
class RecordFields {
 public:
  bool parse(std::uint8_t* bytes, std::uint32_t size) {
    header_ = ros::Header();
    std::string error;
    return header_.parse(bytes, size, error);
  }

  /// Returns the field's bytes; empty if there is no such field.
  std::string text(const std::string& name) const {
    std::string value;
    header_.getValue(name, value);
    return value;
  }

  /// Returns the number at the offset `at` [bytes] of the field; 0 if there is none.
  std::uint32_t number(const std::string& name, std::size_t at = 0) const {
    const std::string bytes = text(name);
    if (bytes.size() < at + 4) return 0;
    return numberAt(reinterpret_cast<const std::uint8_t*>(bytes.data()) + at);
  }

  /// Returns the record type (field "op"); 0 if there is none.
  unsigned operation() const {
    const std::string value = text(rosbag::OP_FIELD_NAME);
    return value.size() == 1 ? static_cast<unsigned char>(value[0]) : 0;
  }

  boost::shared_ptr<ros::M_string> all() { return header_.getValues(); }

 private:
  ros::Header header_;
};

}  // namespace line_plane_segmentation
