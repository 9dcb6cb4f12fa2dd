// SPDX-License-Identifier: BSD-3-Clause
#include "bag_index.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <set>
#include <vector>

#include "bag_record.h"
#include "interruption.h"

namespace line_plane_segmentation {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kIndexEntry = 12;  // [bytes] a time and an offset

/// Reads the records of a bag in order, and checks that each is inside the file.
class IndexCheck {
 public:
  /// @param file  a bag of format 2.0
  explicit IndexCheck(const std::filesystem::path& file)
      : stream_(file, std::ios::binary), size_(std::filesystem::file_size(file)) {
    std::string version;
    std::getline(stream_, version);
    at_ = first_record_ = static_cast<std::uint64_t>(stream_.tellg());
  }

  std::string encryptor() {
    Record head;
    if (!readHead(size_, head) || head.operation != rosbag::OP_FILE_HEADER) return {};
    return fields_.text(rosbag::ENCRYPTOR_FIELD_NAME);
  }

  std::string run() {
    if (!encryptor().empty()) return {};
    index_start_ = fields_.number(rosbag::INDEX_POS_FIELD_NAME) |
                   std::uint64_t{fields_.number(rosbag::INDEX_POS_FIELD_NAME, 4)} << 32U;
    expected_chunks_ = fields_.number(rosbag::CHUNK_COUNT_FIELD_NAME);
    expected_connections_ = fields_.number(rosbag::CONNECTION_COUNT_FIELD_NAME);
    if (index_start_ == 0) return {};
    return checkRecords();
  }

 private:
  struct Record {
    std::uint64_t start = 0;
    std::uint64_t data = 0;  // where its data begins
    std::uint64_t end = 0;
    unsigned operation = 0;
  };

  std::string checkRecords() {
    goTo(first_record_);
    while (at_ < size_) {
      stopIfInterrupted();
      Record record;
      if (!readHead(size_, record)) return "a record does not fit into the file";
      starts_index_ |= record.start == index_start_ && record.operation != rosbag::OP_INDEX_DATA;
      if (record.operation == rosbag::OP_CONNECTION)
        connections_.insert(fields_.number(rosbag::CONNECTION_FIELD_NAME));
      if (record.operation == rosbag::OP_CHUNK_INFO && !isChunk(fields_))
        return "it tells of a chunk that is not there";
      if (record.operation == rosbag::OP_CHUNK && !checkChunk(record)) return "a chunk is broken";
      if (record.operation == rosbag::OP_INDEX_DATA && !checkEntries(record)) return "its index is broken";
      goTo(record.end);
    }
    const bool is_whole =
        (starts_index_ || index_start_ == size_) && chunk_starts_.size() >= expected_chunks_ &&
        connections_.size() >= expected_connections_ &&
        std::includes(connections_.begin(), connections_.end(), indexed_.begin(), indexed_.end());
    return is_whole ? "" : "its index is not whole";
  }

  bool readHead(std::uint64_t limit, Record& record) {
    std::uint32_t header_size = 0;
    std::uint32_t data_size = 0;
    record.start = at_;
    if (!readNumber(limit, header_size) || header_size > kLargestRecordHeader || header_size > limit - at_) {
      return false;
    }
    header_.resize(header_size);
    if (!read(limit, header_.data(), header_size) || !fields_.parse(header_.data(), header_size))
      return false;
    if (!readNumber(limit, data_size) || data_size > limit - at_) return false;
    record.data = at_;
    record.end = at_ + data_size;
    record.operation = fields_.operation();
    return true;
  }

  bool isChunk(const RecordFields& fields) const {
    const std::uint64_t low = fields.number(rosbag::CHUNK_POS_FIELD_NAME);
    const std::uint64_t high = fields.number(rosbag::CHUNK_POS_FIELD_NAME, 4);
    return chunk_starts_.count(low | high << 32U) != 0;
  }

  // The index entries that follow refer to this chunk. The content of compressed chunks is not checked here,
  // because they have checksums.
  bool checkChunk(const Record& record) {
    chunk_starts_.insert(record.start);
    const bool is_plain = fields_.text(rosbag::COMPRESSION_FIELD_NAME) == rosbag::COMPRESSION_NONE;
    chunk_size_ = fields_.number(rosbag::SIZE_FIELD_NAME);
    message_starts_.clear();
    is_plain_ = is_plain;
    if (chunk_size_ == 0 || chunk_size_ > kLargestChunk || record.end == record.data) return false;
    if (!is_plain) return true;
    if (chunk_size_ != record.end - record.data) return false;
    while (at_ < record.end) {
      Record message;
      if (!readHead(record.end, message)) return false;
      message_starts_.insert(static_cast<std::uint32_t>(message.start - record.data));
      goTo(message.end);
    }
    return true;
  }

  bool checkEntries(const Record& record) {
    indexed_.insert(fields_.number(rosbag::CONNECTION_FIELD_NAME));
    const std::uint64_t count = fields_.number(rosbag::COUNT_FIELD_NAME);
    if (count * kIndexEntry != record.end - record.data) return false;
    Bytes entries(static_cast<std::size_t>(record.end - record.data));
    if (!read(record.end, entries.data(), entries.size())) return false;
    for (std::size_t i = 0; i < entries.size(); i += kIndexEntry) {
      const std::uint32_t offset = numberAt(entries.data() + i + 8);
      if (offset >= chunk_size_ || (is_plain_ && message_starts_.count(offset) == 0)) return false;
    }
    return true;
  }

  bool readNumber(std::uint64_t limit, std::uint32_t& number) {
    std::array<std::uint8_t, 4> bytes{};
    if (!read(limit, bytes.data(), bytes.size())) return false;
    number = numberAt(bytes.data());
    return true;
  }

  bool read(std::uint64_t limit, std::uint8_t* bytes, std::size_t size) {
    if (size > limit - at_) return false;
    stream_.read(reinterpret_cast<char*>(bytes), static_cast<std::streamsize>(size));
    at_ += size;
    return static_cast<bool>(stream_);
  }

  // Short distances are skipped by reading, because seeking discards the stream's read buffer.
  void goTo(std::uint64_t position) {
    constexpr std::uint64_t kNear = 1024;
    const std::uint64_t distance = position - at_;
    if (position >= at_ && distance <= kNear) {
      stream_.ignore(static_cast<std::streamsize>(distance));
    } else {
      stream_.seekg(static_cast<std::streamoff>(position));
    }
    at_ = position;
  }

  std::ifstream stream_;
  std::uint64_t size_;
  std::uint64_t first_record_ = 0;
  std::uint64_t at_ = 0;
  std::uint64_t index_start_ = 0;
  bool starts_index_ = false;  // there is a record at index_start_
  Bytes header_;
  RecordFields fields_;
  std::set<std::uint64_t> chunk_starts_;
  std::set<std::uint32_t> message_starts_;  // in the last chunk, if it is plain
  std::uint64_t chunk_size_ = 0;
  bool is_plain_ = false;
  std::set<std::uint32_t> connections_;  // those after the last chunk
  std::set<std::uint32_t> indexed_;      // connections that messages are indexed for
  std::uint64_t expected_chunks_ = 0;
  std::uint64_t expected_connections_ = 0;
};

}  // namespace

std::string encryptorOf(const std::filesystem::path& file) { return IndexCheck(file).encryptor(); }

std::string problemOfIndex(const std::filesystem::path& file) { return IndexCheck(file).run(); }

}  // namespace line_plane_segmentation
