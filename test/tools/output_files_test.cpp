// SPDX-License-Identifier: BSD-3-Clause
#include "output_files.h"

#include <gtest/gtest.h>

#include "run_tool.h"
#include "temporary_folder.h"

namespace line_plane_segmentation {
namespace {

using Names = std::vector<std::string>;

TEST(OutputFiles, AppearTogetherWhenCommitted) {
  const TemporaryFolder folder;
  OutputFiles files;
  files.add(folder / "a.txt", std::string("first"));
  files.add(folder / "b.png", std::vector<unsigned char>{1, 2, 3});
  EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
  files.commit();
  EXPECT_EQ(namesIn(folder.path()), (Names{"a.txt", "b.png"}));
  EXPECT_EQ(textOf(folder / "a.txt"), "first");
  EXPECT_EQ(textOf(folder / "b.png"), "\1\2\3");
}

TEST(OutputFiles, LeaveNothingUnlessCommitted) {
  const TemporaryFolder folder;
  {
    OutputFiles files;
    files.add(folder / "a.txt", std::string("first"));
  }
  EXPECT_EQ(namesIn(folder.path()), Names{});
}

TEST(OutputFiles, KeepWhatWasThereUnlessCommitted) {
  const TemporaryFolder folder;
  folder.write("a.txt", "old");
  {
    OutputFiles files;
    files.add(folder / "a.txt", std::string("new"));
  }
  EXPECT_EQ(textOf(folder / "a.txt"), "old");
  OutputFiles files;
  files.add(folder / "a.txt", std::string("new"));
  files.commit();
  EXPECT_EQ(textOf(folder / "a.txt"), "new");
  EXPECT_EQ(namesIn(folder.path()), Names{"a.txt"});
}

TEST(OutputFiles, NameTheFileThatCannotBeWritten) {
  const TemporaryFolder folder;
  OutputFiles files;
  try {
    files.add(folder / "missing" / "a.txt", std::string("text"));
    FAIL() << "wrote into a folder that does not exist";
  } catch (const BadInput& error) {
    EXPECT_NE(std::string(error.what()).find("missing/a.txt"), std::string::npos) << error.what();
  }
}

TEST(MakeOutputFolder, MakesItWithItsParentsAndAcceptsOneThatIsThere) {
  const TemporaryFolder folder;
  makeOutputFolder(folder / "a" / "b");
  EXPECT_TRUE(std::filesystem::is_directory(folder / "a" / "b"));
  EXPECT_NO_THROW(makeOutputFolder(folder / "a" / "b"));
}

TEST(MakeOutputFolder, RefusesAFileAndAFolderBelowAFile) {
  const TemporaryFolder folder;
  folder.write("file", "");
  EXPECT_THROW(makeOutputFolder(folder / "file"), BadInput);
  EXPECT_THROW(makeOutputFolder(folder / "file" / "below"), BadInput);
}

}  // namespace
}  // namespace line_plane_segmentation
