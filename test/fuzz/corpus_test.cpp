// SPDX-License-Identifier: BSD-3-Clause
// Every input of the corpus, with every compiler and without a fuzzer.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

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
        << name << ": make_test_corpus test/fuzz/corpus writes it anew";
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, Corpus,
                         testing::Values(Target{"frame", tryFrame}, Target{"cloud", tryCloud},
                                         Target{"parameters", tryParameters}),
                         [](const auto& target) { return std::string(target.param.name); });

}  // namespace
}  // namespace line_plane_segmentation
