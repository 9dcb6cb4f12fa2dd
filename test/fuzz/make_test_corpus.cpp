// SPDX-License-Identifier: BSD-3-Clause
// Writes the seeds to test/fuzz/corpus: make_test_corpus FOLDER. Other files there stay: inputs that once
// found something.
#include <filesystem>
#include <fstream>
#include <iostream>

#include "seeds.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "Usage: make_test_corpus FOLDER\n";
    return 1;
  }
  for (const auto& [target, seeds] : line_plane_segmentation::seeds()) {
    const std::filesystem::path folder = std::filesystem::path(argv[1]) / target;
    std::filesystem::create_directories(folder);
    for (const auto& [name, bytes] : seeds) {
      std::ofstream file(folder / name, std::ios::binary);
      file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }
  }
}
