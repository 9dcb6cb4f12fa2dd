// SPDX-License-Identifier: BSD-3-Clause
// segment_bag on bags that broke: what is whole is done, one line tells of the rest, the exit code is 1.
#include <gtest/gtest.h>
#include <line_plane_segmentation/PlaneArray.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "temporary_folder.h"
#include "test_bag.h"
#include "tool_process.h"

namespace line_plane_segmentation {
namespace {

constexpr int kFrames = 12;
constexpr char kPlanes[] = "/camera/plane_segmenter/planes";
// About two images in a chunk.
constexpr std::uint32_t kChunkBytes = 60000;

class DamagedBag : public testing::TestWithParam<rosbag::CompressionType> {
 protected:
  void SetUp() override {
    writeWallBag(folder_ / "whole.bag", kFrames, GetParam(), kChunkBytes);
    bytes_ = textOf(folder_ / "whole.bag");
  }

  // Segments these bytes as a bag. Returns the stamps of the frames that came out.
  std::vector<ros::Time> segment(const std::string& bytes, const std::string& reason,
                                 const std::vector<std::string>& options = {}) {
    folder_.write("in.bag", bytes);
    std::filesystem::remove(folder_ / "out.bag");
    std::vector<std::string> arguments{(folder_ / "in.bag").string(), (folder_ / "out.bag").string()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ToolResult result = runProcess(SEGMENT_BAG, arguments);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_NE(result.err.find(reason), std::string::npos) << result.err;
    std::vector<ros::Time> stamps;
    if (!std::filesystem::exists(folder_ / "out.bag")) return stamps;
    const auto messages = readAll<PlaneArray>(folder_ / "out.bag");
    for (const auto& message : messages.at(kPlanes)) {
      EXPECT_EQ(message->planes.size(), 1U);
      stamps.push_back(message->header.stamp);
    }
    return stamps;
  }

  static std::vector<ros::Time> firstStamps(std::size_t count) {
    std::vector<ros::Time> stamps;
    for (std::size_t i = 0; i < count; ++i) stamps.push_back(stampOf(static_cast<int>(i)));
    return stamps;
  }

  // As it is in the file while a recording is going on: the place of the index is not known yet.
  static std::string unfinished(std::string bytes) {
    const std::size_t field = bytes.find("index_pos=") + 10;
    return bytes.replace(field, 8, 8, '\0');
  }

  TemporaryFolder folder_;
  std::string bytes_;
};

TEST_P(DamagedBag, CutOffAnywhere) {
  std::size_t before = 0;
  for (const double share : {0.4, 0.6, 0.8}) {
    const auto size = static_cast<std::size_t>(share * static_cast<double>(bytes_.size()));
    const std::vector<ros::Time> stamps =
        segment(bytes_.substr(0, size), "cut off; what could be read is done");
    // Of a chunk that is cut, nothing or a part can be read.
    const double whole = share * kFrames;
    EXPECT_GE(static_cast<double>(stamps.size()), whole - 4.0);
    // The last image may be whole though its camera_info is cut off: the one before it does for both.
    EXPECT_LE(static_cast<double>(stamps.size()), whole + 1.0);
    EXPECT_LE(static_cast<double>(segment(bytes_.substr(0, size), "cut off; what could be read is done",
                                          {"--set", "info_matching=exact"})
                                      .size()),
              whole);
    EXPECT_GT(stamps.size(), before);
    EXPECT_EQ(stamps, firstStamps(stamps.size()));
    before = stamps.size();
  }
}

TEST_P(DamagedBag, WithoutIndex) {
  const std::string open = unfinished(bytes_);
  EXPECT_EQ(segment(open, "the recording was not finished"), firstStamps(kFrames));
}

TEST_P(DamagedBag, CutBeforeTheFirstImage) {
  EXPECT_TRUE(segment(bytes_.substr(0, 13), "holds no depth images").empty());
  EXPECT_TRUE(segment(bytes_.substr(0, 5000), "holds no depth images").empty());
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out.bag"));
}

TEST_P(DamagedBag, BrokenInTheMiddle) {
  std::string broken = bytes_;
  const auto middle = static_cast<std::ptrdiff_t>(broken.size() / 2);
  std::fill(broken.begin() + middle, broken.begin() + middle + 2000, '\xff');
  if (GetParam() == rosbag::compression::Uncompressed) {
    // Pixels, most likely: nobody can tell. Without an exit code to go by, at least nothing must crash.
    folder_.write("in.bag", broken);
    const ToolResult result =
        runProcess(SEGMENT_BAG, {(folder_ / "in.bag").string(), (folder_ / "out.bag").string()});
    EXPECT_GE(result.exit_code, 0);
    return;
  }
  for (const std::string& bytes : {broken, unfinished(broken)}) {
    const std::vector<ros::Time> stamps = segment(bytes, "what could be read is done");
    EXPECT_GE(stamps.size(), kFrames - 4U);
    EXPECT_LT(stamps.size(), static_cast<std::size_t>(kFrames));
    EXPECT_EQ(stamps.front(), stampOf(0));
    EXPECT_EQ(stamps.back(), stampOf(kFrames - 1));
  }
}

TEST_P(DamagedBag, LastChunkStillOpen) {
  // The file as it is before the chunk's length is known: it stands at 0, and the file ends in the chunk.
  // Without compression all but the last message can be read.
  // It is the last but one here, the last has no image.
  const std::size_t last_chunk = bytes_.rfind("compression=", bytes_.rfind("compression=") - 1);
  const std::size_t header_end = bytes_.find("size=", last_chunk) + 9;
  std::string open = unfinished(bytes_).replace(header_end, 4, 4, '\0');
  open.resize(header_end + 4 + 45000 / (GetParam() == rosbag::compression::Uncompressed ? 1 : 4));
  const std::vector<ros::Time> stamps = segment(open, "cut off");
  EXPECT_GE(stamps.size(), kFrames - (GetParam() == rosbag::compression::Uncompressed ? 2U : 3U));
  EXPECT_LT(stamps.size(), static_cast<std::size_t>(kFrames));
  EXPECT_EQ(stamps, firstStamps(stamps.size()));
}

TEST_P(DamagedBag, RandomBytesAtTheEnd) {
  const std::string cut = bytes_.substr(0, bytes_.size() / 2) + std::string(50000, '\x7f');
  const std::vector<ros::Time> stamps = segment(cut, "what could be read is done");
  EXPECT_GE(stamps.size(), kFrames / 2 - 3U);
}

// What rosbag's library follows without a look, into memory that is not there.
TEST_P(DamagedBag, WrongIndex) {
  const std::size_t index = bytes_.find("op=\x04");
  const std::size_t entry = bytes_.find("ver=", index) + 8 + 4;  // after the length of the data
  ASSERT_LT(entry + 12, bytes_.size());
  const auto changed = [this](std::size_t at, const std::string& with) {
    return std::string(bytes_).replace(at, with.size(), with);
  };
  const std::size_t index_pos = bytes_.find("index_pos=") + 10;
  const std::size_t chunk_pos = bytes_.find("chunk_pos=") + 10;
  const std::size_t connections = bytes_.rfind("op=\x07");
  const std::pair<const char*, std::string> kCases[] = {
      {"offset beyond the chunk", changed(entry + 8, std::string("\0\0\0\x10", 4))},
      {"offset at the end", changed(entry + 8, "\xff\xff\xff\xff")},
      {"index that begins elsewhere", changed(index_pos, std::string("\x80\x13\0\0\0\0\0\0", 8))},
      {"chunk that is not there", changed(chunk_pos, std::string("\x05\0\0\0\0\0\0\0", 8))},
      {"connection that is not told of", changed(connections, "op=\x01")}};
  for (const auto& [name, bytes] : kCases) {
    SCOPED_TRACE(name);
    EXPECT_GE(segment(bytes, "what could be read is done").size(), kFrames - 2U);
  }
}

TEST_P(DamagedBag, ChunkOfSizeZero) {
  folder_.write("in.bag", std::string(bytes_).replace(bytes_.find("size=") + 5, 4, 4, '\0'));
  const ToolResult result =
      runProcess(SEGMENT_BAG, {(folder_ / "in.bag").string(), (folder_ / "out.bag").string()});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err.find("a chunk is broken"), std::string::npos) << result.err;
}

// Bytes anywhere, one after the other: whatever comes of it, it is no crash.
TEST_P(DamagedBag, WrongBytesAnywhere) {
  std::uint32_t random = 1;
  for (int i = 0; i < 20; ++i) {
    std::string broken = bytes_;
    // Most of them where the structure is, at the chunks' heads and in the index.
    random = random * 1664525U + 1013904223U;
    const char* const kPlaces[] = {"op=", "size=", "conn=", "count=", "chunk_pos=", "time="};
    std::size_t at = random % broken.size();
    at = std::min(broken.find(kPlaces[i % 6], at), broken.size() - 40) + (random >> 24U) % 40;
    broken[at] = static_cast<char>(random >> 16U);
    folder_.write("in.bag", broken);
    const ToolResult result =
        runProcess(SEGMENT_BAG, {(folder_ / "in.bag").string(), (folder_ / "out.bag").string()});
    EXPECT_TRUE(result.exit_code == 0 || result.exit_code == 1) << "byte " << at << ": " << result.err;
  }
}

// Its data cannot be read without the key; the header that says so can.
TEST_P(DamagedBag, Encrypted) {
  const auto text = [](std::uint32_t bits) {
    return std::string(reinterpret_cast<const char*>(&bits), sizeof bits);
  };
  const auto number = [this](std::size_t at) {
    std::uint32_t read = 0;
    std::memcpy(&read, bytes_.data() + at, sizeof read);
    return read;
  };
  const std::string plugin = "rosbag/AesCbcEncryptor";
  const std::string value = "encryptor=" + plugin;
  const std::string field = text(static_cast<std::uint32_t>(value.size())) + value;
  const auto longer = static_cast<std::uint32_t>(field.size());
  // The header's length, its fields, and the length of its padding, which becomes as much shorter.
  const std::size_t head = std::string("#ROSBAG V2.0\n").size();
  const std::uint32_t fields = number(head);
  const std::size_t padding = head + 4 + fields;
  ASSERT_GT(number(padding), longer);
  const std::string bytes = bytes_.substr(0, head) + text(fields + longer) + field +
                            bytes_.substr(head + 4, fields) + text(number(padding) - longer) +
                            bytes_.substr(padding + 4 + longer);
  ASSERT_EQ(bytes.size(), bytes_.size());
  segment(bytes, "is encrypted with " + plugin);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out.bag"));
}

std::string nameOf(const testing::TestParamInfo<rosbag::CompressionType>& info) {
  return info.param == rosbag::compression::LZ4   ? "lz4"
         : info.param == rosbag::compression::BZ2 ? "bz2"
                                                  : "none";
}

INSTANTIATE_TEST_SUITE_P(Compressions, DamagedBag,
                         testing::Values(rosbag::compression::Uncompressed, rosbag::compression::LZ4,
                                         rosbag::compression::BZ2),
                         nameOf);

}  // namespace
}  // namespace line_plane_segmentation
