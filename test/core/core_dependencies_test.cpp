// SPDX-License-Identifier: BSD-3-Clause
// The core is the method and nothing else: it needs Eigen's headers and the C++ library, no ROS, PCL or
// OpenCV.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// What a command prints.
std::string outputOf(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string output;
  std::array<char, 4096> buffer{};
  while (pipe && std::fgets(buffer.data(), buffer.size(), pipe.get()) != nullptr) output += buffer.data();
  return output;
}

std::vector<std::string> matchesOf(const std::string& pattern, const std::string& text) {
  const std::regex regex(pattern);
  std::vector<std::string> matches;
  for (std::sregex_iterator i(text.begin(), text.end(), regex); i != std::sregex_iterator(); ++i)
    matches.push_back((*i)[1]);
  return matches;
}

TEST(CoreDependencies, AreTheLibrariesOfTheCompilerOnly) {
  const std::string needed = outputOf("readelf -d '" CORE_LIBRARY "'");
  const std::vector<std::string> libraries = matchesOf("\\(NEEDED\\)[^\\[]*\\[([^\\]]*)\\]", needed);
  ASSERT_FALSE(libraries.empty()) << "not a shared library: " CORE_LIBRARY << '\n' << needed;
  const std::regex allowed(
      "(libc|libm|libstdc\\+\\+|libgcc_s|libasan|libubsan|libtsan|ld-linux[^.]*)\\.so\\..*");
  for (const std::string& library : libraries) EXPECT_TRUE(std::regex_match(library, allowed)) << library;
}

TEST(CoreDependencies, AreEigenAndTheStandardInEveryFile) {
  int files = 0;
  const std::string include = std::string(SOURCE_FOLDER) + "/include/line_plane_segmentation";
  for (const std::string& folder : {std::string(SOURCE_FOLDER) + "/src/core", include}) {
    for (auto entry = fs::recursive_directory_iterator(folder); entry != fs::recursive_directory_iterator();
         ++entry) {
      if (!entry->is_regular_file() || entry->path().filename() == "CMakeLists.txt") continue;
      ++files;
      std::ifstream stream(entry->path());
      const std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
      for (const std::string& header : matchesOf("#include <([^>]*)>", text)) {
        // The standard's headers have neither folders nor suffixes.
        const bool is_standard = header.find_first_of("/.") == std::string::npos;
        EXPECT_TRUE(is_standard || header.rfind("Eigen/", 0) == 0) << entry->path() << " includes " << header;
      }
      for (const std::string& header : matchesOf("#include \"([^\"]*)\"", text)) {
        const bool is_public = header.rfind("line_plane_segmentation/", 0) == 0;
        const std::string within = is_public ? header.substr(24) : header;
        EXPECT_TRUE(!is_public || within.find('/') == std::string::npos)
            << entry->path() << " leaves the core: " << header;
        const std::string source = std::string(SOURCE_FOLDER) +
                                   (is_public ? "/include/line_plane_segmentation/" : "/src/core/") + within;
        EXPECT_TRUE(fs::exists(source))
            << entry->path() << " includes a file that is made elsewhere: " << header;
      }
    }
  }
  EXPECT_GT(files, 60) << "looked in the wrong place: " SOURCE_FOLDER;
}

}  // namespace
