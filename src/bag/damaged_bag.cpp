// SPDX-License-Identifier: BSD-3-Clause
#include <rosbag/chunked_file.h>
#include <rosbag/stream.h>

#include <algorithm>
#include <array>
#include <boost/make_shared.hpp>
#include <cstring>
#include <fstream>
#include <vector>

#include "bag_input.h"
#include "bag_record.h"
#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

using Bytes = std::vector<std::uint8_t>;

class DamagedBag : public BagInput {
 public:
  DamagedBag(const std::filesystem::path& file, MessageFilter wanted, std::string damage)
      : stream_(file, std::ios::binary),
        size_(std::filesystem::file_size(file)),
        wanted_(std::move(wanted)),
        damage_(std::move(damage)) {
    std::string version;
    std::getline(stream_, version);
    at_ = static_cast<std::uint64_t>(stream_.tellg());
  }

  bool next(BagMessage& message) override {
    for (;;) {
      while (chunk_at_ < chunk_.size()) {
        if (readFromChunk(message)) return true;
      }
      if (at_ == size_) return false;
      const std::uint64_t record = at_;
      if (readFromFile()) continue;
      noteCut(record);
      at_ = size_;
    }
  }

  double fractionRead() const override {
    return size_ == 0 ? 1.0 : static_cast<double>(at_) / static_cast<double>(size_);
  }
  const std::map<std::string, std::string>& topics() const override { return topics_; }
  const std::string& damage() const override { return damage_; }

 private:
  struct Connection {
    std::string topic;
    boost::shared_ptr<ros::M_string> header;
    bool wanted = false;
  };

  // Format of a record: length and bytes of the header, length and bytes of the data. A record that exceeds
  // the chunk is truncated, and parsing ends there.
  bool readFromChunk(BagMessage& message) {
    std::uint8_t* const record = chunk_.data() + chunk_at_;
    const std::uint64_t left = chunk_.size() - chunk_at_;
    chunk_at_ = chunk_.size();
    if (left < 8) return false;
    const std::uint64_t header_size = numberAt(record);
    if (header_size > left - 8 || !fields_.parse(record + 4, static_cast<std::uint32_t>(header_size))) {
      return false;
    }
    const std::uint64_t data_size = numberAt(record + 4 + header_size);
    if (data_size > left - 8 - header_size) return false;
    chunk_at_ = chunk_.size() - left + 8 + header_size + data_size;

    std::uint8_t* const data = record + 8 + header_size;
    if (fields_.operation() == rosbag::OP_CONNECTION)
      addConnection(data, static_cast<std::uint32_t>(data_size));
    return fields_.operation() == rosbag::OP_MSG_DATA &&
           makeMessage(data, static_cast<std::uint32_t>(data_size), message);
  }

  void addConnection(std::uint8_t* data, std::uint32_t size) {
    const std::string topic = fields_.text(rosbag::TOPIC_FIELD_NAME);
    const std::uint32_t id = fields_.number(rosbag::CONNECTION_FIELD_NAME);
    RecordFields header;
    if (!header.parse(data, size)) return;
    connections_[id] = {topic, header.all(), wanted_(topic, header.text("type"))};
  }

  bool makeMessage(std::uint8_t* data, std::uint32_t size, BagMessage& message) const {
    const auto found = connections_.find(fields_.number(rosbag::CONNECTION_FIELD_NAME));
    if (found == connections_.end() || !found->second.wanted) return false;
    ros::M_string& header = *found->second.header;
    auto content = boost::make_shared<topic_tools::ShapeShifter>();
    content->morph(header["md5sum"], header["type"], header["message_definition"], header["latching"]);
    ros::serialization::IStream stream(data, size);
    content->read(stream);
    const ros::Time time(fields_.number(rosbag::TIME_FIELD_NAME), fields_.number(rosbag::TIME_FIELD_NAME, 4));
    message = {found->second.topic, time, content, found->second.header};
    return true;
  }

  // Loads the next record of the file into chunk_: the content of a chunk, or a record outside of chunks.
  bool readFromFile() {
    std::array<std::uint8_t, 4> number{};
    Bytes header;
    if (!read(number.data(), 4) || numberAt(number.data()) > kLargestRecordHeader) return false;
    header.resize(numberAt(number.data()));
    if (!read(header.data(), header.size()) || !read(number.data(), 4)) return false;
    if (!fields_.parse(header.data(), static_cast<std::uint32_t>(header.size()))) return false;
    const std::uint64_t data_size = std::min<std::uint64_t>(numberAt(number.data()), size_ - at_);
    if (data_size < numberAt(number.data())) noteCut(at_);
    if (data_size > kLargestChunk) return false;
    Bytes data(data_size);
    if (!read(data.data(), data.size())) return false;

    chunk_at_ = 0;
    if (fields_.operation() == rosbag::OP_CHUNK) return decompress(data), true;
    // While a chunk is recorded its length in the file is 0, so its records appear to be outside of chunks.
    chunk_.clear();
    append(static_cast<std::uint32_t>(header.size()), header);
    append(numberAt(number.data()), data);
    return true;
  }

  void noteCut(std::uint64_t byte) {
    damage_ += ", and from byte " + std::to_string(byte) + " of " + std::to_string(size_) +
               " on it is broken or cut off";
  }

  void append(std::uint32_t size, const Bytes& bytes) {
    for (int shift = 0; shift < 32; shift += 8) chunk_.push_back(static_cast<std::uint8_t>(size >> shift));
    chunk_.insert(chunk_.end(), bytes.begin(), bytes.end());
  }

  void decompress(Bytes& data) {
    const std::string compression = fields_.text(rosbag::COMPRESSION_FIELD_NAME);
    if (compression == rosbag::COMPRESSION_NONE) {
      chunk_.swap(data);
      return;
    }
    const std::uint32_t size = fields_.number(rosbag::SIZE_FIELD_NAME);
    chunk_.assign(size <= kLargestChunk ? size : 0, 0);
    try {
      const auto kind =
          compression == rosbag::COMPRESSION_BZ2 ? rosbag::compression::BZ2 : rosbag::compression::LZ4;
      streams_.getStream(kind)->decompress(chunk_.data(), size, data.data(),
                                           static_cast<unsigned>(data.size()));
    } catch (const std::exception&) {
      chunk_.clear();  // the next one may be readable
    }
  }

  bool read(std::uint8_t* bytes, std::size_t size) {
    if (size > size_ - at_) return false;
    stream_.read(reinterpret_cast<char*>(bytes), static_cast<std::streamsize>(size));
    at_ += size;
    return static_cast<bool>(stream_);
  }

  std::ifstream stream_;
  std::uint64_t size_;
  std::uint64_t at_ = 0;
  MessageFilter wanted_;
  std::string damage_;
  RecordFields fields_;
  Bytes chunk_;
  std::size_t chunk_at_ = 0;
  std::map<std::uint32_t, Connection> connections_;
  std::map<std::string, std::string> topics_;
  rosbag::ChunkedFile no_file_;  // required by the decompressors
  rosbag::StreamFactory streams_{&no_file_};
};

}  // namespace

std::unique_ptr<BagInput> openDamagedBag(const std::filesystem::path& file, const MessageFilter& wanted,
                                         const std::string& damage) {
  return std::make_unique<DamagedBag>(file, wanted, damage);
}

}  // namespace line_plane_segmentation
