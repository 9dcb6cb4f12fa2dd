// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "byte_reader.h"

namespace line_plane_segmentation {

/// Calls `visitor` for every field that a message's reader looks at, always in the same order.
template <typename Visitor>
void visitFields(std_msgs::Header& header, Visitor& visitor) {
  visitor(header.stamp.sec);
  visitor(header.stamp.nsec);
  visitor(header.frame_id);
}

template <typename Visitor>
void visitFields(sensor_msgs::Image& image, Visitor& visitor) {
  visitFields(image.header, visitor);
  visitor(image.width);
  visitor(image.height);
  visitor(image.encoding);
  visitor(image.is_bigendian);
  visitor(image.step);
  visitor(image.data);
}

template <typename Visitor>
void visitFields(sensor_msgs::CameraInfo& info, Visitor& visitor) {
  visitor(info.width);
  visitor(info.height);
  visitor(info.D);
  for (double& number : info.K) visitor(number);
  for (double& number : info.P) visitor(number);
  visitor(info.binning_x);
  visitor(info.binning_y);
  visitor(info.roi.x_offset);
  visitor(info.roi.y_offset);
  visitor(info.roi.width);
  visitor(info.roi.height);
}

template <typename Visitor>
void visitFields(sensor_msgs::PointField& field, Visitor& visitor) {
  visitor(field.name);
  visitor(field.offset);
  visitor(field.datatype);
}

template <typename Visitor>
void visitFields(sensor_msgs::PointCloud2& cloud, Visitor& visitor) {
  visitFields(cloud.header, visitor);
  visitor(cloud.width);
  visitor(cloud.height);
  visitor(cloud.fields);
  for (sensor_msgs::PointField& field : cloud.fields) visitFields(field, visitor);
  visitor(cloud.is_bigendian);
  visitor(cloud.point_step);
  visitor(cloud.row_step);
  visitor(cloud.data);
}

/// Reads a message that FieldWriter has written, or what any other bytes mean.
class FieldReader {
 public:
  explicit FieldReader(ByteReader& bytes) : bytes_(bytes) {}

  template <typename T>
  std::enable_if_t<std::is_arithmetic<T>::value> operator()(T& number) {
    number = bytes_.raw<T>();
  }
  void operator()(std::string& text) {
    text.resize(std::min<std::size_t>(bytes_.raw<std::uint8_t>(), bytes_.left()));
    bytes_.copy(reinterpret_cast<std::uint8_t*>(&text[0]), text.size());
  }
  void operator()(std::vector<std::uint8_t>& data) {
    // A vector of its own, with no more memory than it has to have: reading beyond the end is noticed.
    std::vector<std::uint8_t> read(std::min<std::size_t>(bytes_.raw<std::uint16_t>(), bytes_.left()));
    bytes_.copy(read.data(), read.size());
    data.swap(read);
  }
  void operator()(std::vector<double>& numbers) {
    numbers.resize(bytes_.raw<std::uint8_t>() % 16U);
    for (double& number : numbers) (*this)(number);
  }
  void operator()(std::vector<sensor_msgs::PointField>& fields) {
    fields.resize(bytes_.raw<std::uint8_t>() % 16U);
  }

 private:
  ByteReader& bytes_;
};

/// Reads messages that writeFields() has written, or what any other bytes mean.
template <typename... Messages>
void readFields(ByteReader& bytes, Messages&... messages) {
  FieldReader reader(bytes);
  (visitFields(messages, reader), ...);
}

/// The other way: the bytes of a message. Long texts are cut off.
class FieldWriter {
 public:
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

  template <typename T>
  std::enable_if_t<std::is_arithmetic<T>::value> operator()(const T& number) {
    const auto* begin = reinterpret_cast<const std::uint8_t*>(&number);
    bytes_.insert(bytes_.end(), begin, begin + sizeof number);
  }
  void operator()(const std::string& text) {
    const std::size_t length = std::min<std::size_t>(text.size(), 255);
    (*this)(static_cast<std::uint8_t>(length));
    bytes_.insert(bytes_.end(), text.begin(), text.begin() + static_cast<std::ptrdiff_t>(length));
  }
  void operator()(const std::vector<std::uint8_t>& data) {
    (*this)(static_cast<std::uint16_t>(data.size()));
    bytes_.insert(bytes_.end(), data.begin(), data.end());
  }
  void operator()(const std::vector<double>& numbers) {
    (*this)(static_cast<std::uint8_t>(numbers.size()));
    for (const double number : numbers) (*this)(number);
  }
  void operator()(const std::vector<sensor_msgs::PointField>& fields) {
    (*this)(static_cast<std::uint8_t>(fields.size()));
  }

 private:
  std::vector<std::uint8_t> bytes_;
};

template <typename... Messages>
std::vector<std::uint8_t> writeFields(Messages&... messages) {
  FieldWriter writer;
  (visitFields(messages, writer), ...);
  return writer.bytes();
}

/// Changes one field of a message to an awkward value.
class FieldAlterer {
 public:
  /// @param index  which; none if there are not so many
  FieldAlterer(int index, ByteReader& bytes) : index_(index), bytes_(bytes) {}

  template <typename T>
  std::enable_if_t<std::is_arithmetic<T>::value> operator()(T& number) {
    if (index_-- == 0) number = bytes_.awkward<T>();
  }
  void operator()(std::string& text) {
    constexpr const char* kTexts[] = {"", "16UC1", "mono16", "32FC1", "64FC1", "rgb8", "x", "y", "z", "/a"};
    if (index_-- == 0) text = kTexts[bytes_.integer(0, 9)];
  }
  void operator()(std::vector<std::uint8_t>& data) {
    if (index_-- != 0) return;
    const std::size_t size = bytes_.chance(128) ? data.size() - std::min<std::size_t>(data.size(), 1)
                                                : bytes_.raw<std::uint16_t>() % (data.size() + 64);
    data.resize(size);
    data.shrink_to_fit();
  }
  template <typename T>
  void operator()(std::vector<T>& list) {
    if (index_-- == 0) list.resize(static_cast<std::size_t>(bytes_.integer(0, 7)));
  }

 private:
  int index_;
  ByteReader& bytes_;
};

/// Changes up to six fields.
template <typename Message>
void alterFields(ByteReader& bytes, Message& message) {
  for (int i = bytes.integer(0, 6); i > 0; --i) {
    FieldAlterer alterer(bytes.integer(0, 39), bytes);
    visitFields(message, alterer);
  }
}

}  // namespace line_plane_segmentation
