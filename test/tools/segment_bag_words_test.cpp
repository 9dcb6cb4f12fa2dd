// SPDX-License-Identifier: BSD-3-Clause
// What segment_bag says about input that it can only use in part.
#include <gtest/gtest.h>

#include "temporary_folder.h"
#include "test_bag.h"
#include "tool_process.h"

namespace line_plane_segmentation {
namespace {

class SegmentBagWords : public testing::Test {
 protected:
  std::string path(const char* name) const { return (folder_ / name).string(); }

  TemporaryFolder folder_;
};

TEST_F(SegmentBagWords, nameAFrameThatTheBagDoesNotKnow) {
  writeWallBag(path("in.bag"), 3);
  for (const std::string frame : {"gravity_frame", "fixed_frame"}) {
    const ToolResult result =
        runProcess(SEGMENT_BAG, {path("in.bag"), path("out.bag"), "--set", frame + "=wrld"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.err.find(frame + " 'wrld': its transforms lead there for no image"), std::string::npos)
        << result.err;
    EXPECT_EQ(countTopics(path("out.bag")).at("/camera/plane_segmenter/planes"), 3);
  }
}

TEST_F(SegmentBagWords, areOnlyAboutDepthInABagOfItsOwn) {
  writeWallBag(path("in.bag"), 3);
  ASSERT_EQ(runProcess(SEGMENT_BAG, {path("in.bag"), path("out.bag"), "--all"}).exit_code, 0);
  const ToolResult again = runProcess(SEGMENT_BAG, {path("out.bag"), path("again.bag")});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(again.out, "/camera/depth/image_raw -> /camera/plane_segmenter: 3 frames, 3 planes\n");
}

// Slow networks and some recorders have images arrive long after their camera_info.
TEST_F(SegmentBagWords, areNotNeededWhereImagesComeLate) {
  constexpr int kLag = 30;
  {
    rosbag::Bag bag(path("in.bag"), rosbag::bagmode::Write);
    for (int i = 0; i < kLag + 5; ++i) {
      bag.write("/camera/depth/camera_info", recordingTime(i), wallInfo(i));
      if (i >= kLag) bag.write("/camera/depth/image_raw", recordingTime(i), wallImage(i - kLag));
    }
  }
  const ToolResult result = runProcess(SEGMENT_BAG, {path("in.bag"), path("out.bag")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "/camera/depth/image_raw -> /camera/plane_segmenter: 5 frames, 5 planes\n");
}

}  // namespace
}  // namespace line_plane_segmentation
