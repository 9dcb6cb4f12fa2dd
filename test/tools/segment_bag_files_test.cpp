// SPDX-License-Identifier: BSD-3-Clause
// Where segment_bag writes: full disks, devices, and other names of its input.
#include <sys/stat.h>

#include <filesystem>

#include "segment_bag_fixture.h"

namespace line_plane_segmentation {
namespace {

using SegmentBagFiles = SegmentBagInput;
using Names = std::vector<std::string>;

TEST_F(SegmentBagFiles, EndWithTheReasonOnAFullDisk) {
  writeBag(writeInfoOn(kInfo));
  const std::string reason = "/dev/full: cannot be written, No space left on device";
  expectRefusal(run({"--csv", "/dev/full"}), "segment_bag", reason);
  expectRefusal(runProcess(SEGMENT_BAG, {in(), "/dev/full"}), "segment_bag", reason);
  EXPECT_EQ(namesIn(folder_.path()), Names{"in.bag"});
}

// Both outputs, at all sizes at which the disk can be full.
TEST_F(SegmentBagFiles, LeaveNothingWhereverTheDiskIsFull) {
  writeBag(writeInfoOn(kInfo));
  for (const char* blocks : {"1", "4", "8", "12"}) {
    const ToolResult full = run({"--csv", (folder_ / "planes.csv").string(), "--all"},
                                std::string("trap '' XFSZ; ulimit -f ") + blocks + ";");
    expectRefusal(full, "segment_bag", "cannot be written, File too large");
    EXPECT_EQ(namesIn(folder_.path()), Names{"in.bag"}) << blocks;
  }
}

TEST_F(SegmentBagFiles, TellWhenStandardOutputIsFull) {
  writeBag(writeInfoOn(kInfo));
  const ToolResult result =
      runProcess("/bin/sh", {"-c", std::string(SEGMENT_BAG) + " " + in() + " " + out() + " >/dev/full"});
  expectRefusal(result, "segment_bag", "standard output cannot be written, No space left on device");
  EXPECT_TRUE(std::filesystem::exists(out()));
}

TEST_F(SegmentBagFiles, AreWrittenThroughDevices) {
  writeBag(writeInfoOn(kInfo));
  const ToolResult nowhere = runProcess(SEGMENT_BAG, {in(), "/dev/null"});
  EXPECT_EQ(nowhere.exit_code, 0) << nowhere.err;
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  // Standard output, redirected to a file and to a pipe.
  const std::string command = std::string(SEGMENT_BAG) + " " + in() + " " + out() + " --csv /dev/stdout";
  for (const std::string& pipe : {std::string(), std::string(" | cat")}) {
    const ToolResult table = runProcess("/bin/sh", {"-c", command + pipe});
    EXPECT_EQ(table.exit_code, 0) << table.err;
    EXPECT_EQ(table.err, "");
    EXPECT_NE(table.out.find("topic,stamp,id"), std::string::npos) << table.out;
    EXPECT_NE(table.out.find("/camera/depth/image_raw,1000"), std::string::npos) << table.out;
  }
}

// Writing a bag goes back to its start, which a pipe does not do.
TEST_F(SegmentBagFiles, AreNoPipes) {
  writeBag(writeInfoOn(kInfo));
  const std::string fifo = (folder_ / "fifo").string();
  ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
  for (const std::string& name : {std::string("/dev/stdout"), std::string("/dev/fd/1"), fifo}) {
    expectRefusal(runProcess(SEGMENT_BAG, {in(), name}), "segment_bag",
                  name + ": a bag can only be written to a file");
  }
}

TEST_F(SegmentBagFiles, NeverReplaceTheInput) {
  writeBag(writeInfoOn(kInfo));
  const std::string before = textOf(in());
  const std::string hard = (folder_ / "hard.bag").string();
  const std::string soft = (folder_ / "soft.bag").string();
  std::filesystem::create_hard_link(in(), hard);
  std::filesystem::create_symlink("in.bag", soft);
  for (const std::string& name : {in(), hard, soft}) {
    expectRefusal(runProcess(SEGMENT_BAG, {in(), name}), "segment_bag", "would overwrite");
    expectRefusal(run({"--csv", name}), "segment_bag", "would overwrite");
  }
  EXPECT_EQ(textOf(in()), before);
  EXPECT_EQ(namesIn(folder_.path()), (Names{"hard.bag", "in.bag", "soft.bag"}));
}

}  // namespace
}  // namespace line_plane_segmentation
