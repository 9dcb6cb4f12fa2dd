// SPDX-License-Identifier: BSD-3-Clause
// Every input of the corpus, with every compiler and without a fuzzer.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "cloud_validation.h"
#include "message_fields.h"
#include "ros/cloud_validation_cases.h"
#include "ros/image_validation_cases.h"
#include "seeds.h"
#include "targets.h"

namespace line_plane_segmentation {
namespace {

namespace fs = std::filesystem;

std::vector<std::uint8_t> readFile(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

struct Target {
  const char* name;
  void (*run)(const std::uint8_t*, std::size_t);
};

void PrintTo(const Target& target, std::ostream* stream) { *stream << target.name; }

class Corpus : public testing::TestWithParam<Target> {
 protected:
  std::vector<fs::path> files() const {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(fs::path(CORPUS_FOLDER) / GetParam().name)) {
      found.push_back(entry.path());
    }
    std::sort(found.begin(), found.end());
    return found;
  }
};

TEST_P(Corpus, keepsThePromises) {
  ASSERT_FALSE(files().empty());
  for (const fs::path& path : files()) {
    SCOPED_TRACE(path);
    const std::vector<std::uint8_t> bytes = readFile(path);
    GetParam().run(bytes.data(), bytes.size());
  }
}

TEST_P(Corpus, holdsEveryRowOfTheTables) {
  const Seeds expected = seeds().at(GetParam().name);
  for (const auto& [name, bytes] : expected) {
    EXPECT_EQ(bytes, readFile(fs::path(CORPUS_FOLDER) / GetParam().name / name))
        << name
        << ": build the target make_test_corpus, then "
           "`build/devel/lib/line_plane_segmentation/make_test_corpus "
           "test/fuzz/corpus` writes it anew";
  }
}

template <typename... Messages>
void readSeed(const char* target, const char* row, Messages&... messages) {
  const std::vector<std::uint8_t> bytes = readFile(fs::path(CORPUS_FOLDER) / target / seedNameOf(row));
  ByteReader reader(bytes.data(), bytes.size());
  EXPECT_EQ(0, reader.integer(0, 255)) << "a scene is drawn, not the message read";
  readFields(reader, messages...);
  EXPECT_EQ(0U, reader.left());
}

// A seed whose bytes mean something else by now would be tried without a word.
TEST(Seeds, ofImagesStillMeanTheirRows) {
  for (const ValidationCase& row : validationCases()) {
    SCOPED_TRACE(row.what);
    sensor_msgs::Image image;
    sensor_msgs::CameraInfo info;
    readSeed("frame", row.what, image, info);
    EXPECT_STREQ(nameOf(row.expected), nameOf(validate(image, info).refusal));
  }
}

TEST(Seeds, ofCloudsStillMeanTheirRows) {
  for (const CloudCase& row : cloudCases()) {
    SCOPED_TRACE(row.what);
    sensor_msgs::PointCloud2 cloud;
    readSeed("cloud", row.what, cloud);
    std::vector<std::uint8_t> depth;
    EXPECT_STREQ(nameOf(row.expected), nameOf(validate(cloud, InputLimits{}, depth).refusal));
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, Corpus,
                         testing::Values(Target{"frame", tryFrame}, Target{"cloud", tryCloud},
                                         Target{"parameters", tryParameters}),
                         [](const auto& target) { return std::string(target.param.name); });

}  // namespace
}  // namespace line_plane_segmentation
