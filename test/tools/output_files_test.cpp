// SPDX-License-Identifier: BSD-3-Clause
#include "output_files.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <future>

#include "run_tool.h"
#include "temporary_folder.h"

namespace line_plane_segmentation {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

// The message of the refusal; empty if nothing is refused.
template <typename Action>
std::string refusalOf(Action&& action) {
  try {
    action();
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

std::string refusalToAdd(const fs::path& file, const fs::path& input = "") {
  return refusalOf([&] {
    OutputFiles files;
    if (!input.empty()) files.protect(input);
    files.add(file, std::string("new"));
    files.commit();
  });
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(OutputFiles, AppearTogetherWhenCommitted) {
  const TemporaryFolder folder;
  OutputFiles files;
  files.add(folder / "a.txt", std::string("first"));
  files.add(folder / "b.png", std::vector<unsigned char>{1, 2, 3});
  EXPECT_FALSE(fs::exists(folder / "a.txt"));
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
    std::ofstream(files.reserve(folder / "b.txt")) << "second";
  }
  EXPECT_EQ(namesIn(folder.path()), Names{});
}

TEST(OutputFiles, KeepThePreviousFileUnlessCommitted) {
  const TemporaryFolder folder;
  folder.write("a.txt", "old");
  {
    OutputFiles files;
    files.add(folder / "a.txt", std::string("new"));
  }
  EXPECT_EQ(textOf(folder / "a.txt"), "old");
  EXPECT_EQ(refusalToAdd(folder / "a.txt"), "");
  EXPECT_EQ(textOf(folder / "a.txt"), "new");
  EXPECT_EQ(namesIn(folder.path()), Names{"a.txt"});
}

TEST(OutputFiles, AreWrittenByNameWhereReserved) {
  const TemporaryFolder folder;
  OutputFiles files;
  std::ofstream(files.reserve(folder / "a.txt")) << "text";
  files.commit();
  EXPECT_EQ(textOf(folder / "a.txt"), "text");
  struct stat made {};
  ASSERT_EQ(stat((folder / "a.txt").c_str(), &made), 0);
  const mode_t mask = umask(0);
  umask(mask);
  EXPECT_EQ(made.st_mode & 0777, 0666 & ~mask) << "others cannot read it";
}

TEST(OutputFiles, NameTheFileThatCannotBeWritten) {
  const TemporaryFolder folder;
  EXPECT_TRUE(
      contains(refusalToAdd(folder / "missing" / "a.txt"), "missing/a.txt: cannot be written, No such"));
  EXPECT_TRUE(contains(refusalToAdd(folder.path()), "is a folder"));
  EXPECT_TRUE(contains(refusalToAdd(folder / std::string(300, 'x')), "name too long"));
}

TEST(OutputFiles, LeaveNothingWhenTheProcessIsKilled) {
  const TemporaryFolder folder;
  const pid_t child = fork();
  if (child == 0) {
    OutputFiles files;
    files.add(folder / "a.txt", std::string("text"));
    raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(namesIn(folder.path()), Names{});
}

TEST(OutputFiles, OfTwoProcessesAreBothWhole) {
  const TemporaryFolder folder;
  OutputFiles first, second;
  std::ofstream one(first.reserve(folder / "a.txt")), two(second.reserve(folder / "a.txt"));
  one << "one" << std::flush;
  two << "second" << std::flush;
  one.close();
  two.close();
  first.commit();
  EXPECT_EQ(textOf(folder / "a.txt"), "one");
  second.commit();
  EXPECT_EQ(textOf(folder / "a.txt"), "second");
  EXPECT_EQ(namesIn(folder.path()), Names{"a.txt"});
}

TEST(OutputFiles, ReplaceTheTargetOfASymbolicLink) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "data");
  folder.write("data/a.txt", "old");
  fs::create_symlink("data/a.txt", folder / "link");
  fs::create_symlink("nowhere", folder / "dangling");
  EXPECT_EQ(refusalToAdd(folder / "link"), "");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(textOf(folder / "data/a.txt"), "new");
  EXPECT_EQ(namesIn(folder / "data"), Names{"a.txt"});
  EXPECT_TRUE(contains(refusalToAdd(folder / "dangling"), "link to a file that does not exist"));
}

TEST(OutputFiles, WriteToDevicesAndFifos) {
  const TemporaryFolder folder;
  EXPECT_EQ(refusalToAdd("/dev/null"), "");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_TRUE(contains(refusalToAdd("/dev/full"), "/dev/full: cannot be written, No space left"));

  const std::string fifo = (folder / "fifo").string();
  ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
  std::future<std::string> reader = std::async(std::launch::async, [&fifo] { return textOf(fifo); });
  EXPECT_EQ(refusalToAdd(fifo), "");
  EXPECT_EQ(reader.get(), "new");
  EXPECT_TRUE(fs::is_fifo(fifo));
}

TEST(OutputFiles, WriteToStandardOutputBesideAFile) {
  const TemporaryFolder folder;
  OutputFiles files;
  files.add("/dev/stdout", std::string("on standard output\n"));
  files.add(folder / "a.txt", std::string("text"));
  files.commit();
  EXPECT_EQ(namesIn(folder.path()), Names{"a.txt"});
}

// A standard output that is redirected to a file has one position for all that is written to it.
TEST(OutputFiles, ShareThePositionOfOpenFiles) {
  const TemporaryFolder folder;
  const int open_file = ::open((folder / "a.txt").c_str(), O_CREAT | O_WRONLY, 0600);
  ASSERT_GE(open_file, 0);
  const std::string name = "/dev/fd/" + std::to_string(open_file);
  ASSERT_EQ(write(open_file, "before ", 7), 7);
  OutputFiles files;
  files.add(name, std::string("text "));
  files.append(name, "and more ");
  files.commit();
  ASSERT_EQ(write(open_file, "after", 5), 5);
  close(open_file);
  EXPECT_EQ(textOf(folder / "a.txt"), "before text and more after");
}

TEST(OutputFiles, AreContinued) {
  const TemporaryFolder folder;
  OutputFiles files;
  files.add(folder / "a.txt", std::string("one, "));
  files.add(folder / "b.txt", std::string("other"));
  files.append(folder / "a.txt", "two");
  files.commit();
  EXPECT_EQ(textOf(folder / "a.txt"), "one, two");
  EXPECT_EQ(textOf(folder / "b.txt"), "other");
}

TEST(OutputFiles, NeverReplaceAnInput) {
  const TemporaryFolder folder;
  const fs::path input = folder.write("input", "precious");
  fs::create_symlink("input", folder / "link");
  fs::create_hard_link(input, folder / "hard");
  for (const char* name : {"input", "link", "hard"}) {
    EXPECT_TRUE(contains(refusalToAdd(folder / name, input), "would overwrite the input")) << name;
  }
  EXPECT_EQ(refusalToAdd(folder / "other", input), "");
  EXPECT_EQ(textOf(input), "precious");
}

TEST(OutputFiles, AreNotNamedTwice) {
  const TemporaryFolder folder;
  OutputFiles files;
  files.add(folder / "a.txt", std::string("one"));
  EXPECT_TRUE(contains(refusalOf([&] { files.add(folder / "." / "a.txt", std::string("two")); }),
                       "two outputs have this name"));
}

TEST(MakeOutputFolder, MakesItWithItsParentsAndAcceptsOneThatIsThere) {
  const TemporaryFolder folder;
  makeOutputFolder(folder / "a" / "b");
  EXPECT_TRUE(fs::is_directory(folder / "a" / "b"));
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
