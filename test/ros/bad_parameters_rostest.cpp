// SPDX-License-Identifier: BSD-3-Clause
// Started with parameters that make no sense, the segmenter stays alive, idle, and says what is wrong.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>

#include <string>

#include "test_camera.h"

namespace line_plane_segmentation {
namespace {

TEST(BadParameters, areNamedInTheDiagnostics) {
  const TestCamera camera;
  const Inbox<diagnostic_msgs::DiagnosticArray> diagnostics("/diagnostics");
  std::string message;
  ASSERT_TRUE(waitUntil([&] {
    if (!diagnostics.newest()) return false;
    const auto& status = diagnostics.newest()->status.at(0);
    message = status.message;
    return status.name == "plane_segmenter: plane segmentation" &&
           status.level == diagnostic_msgs::DiagnosticStatus::ERROR;
  }));
  for (const char* name : {"~plane_distance", "~max_range", "~trace_outlines"}) {
    EXPECT_NE(std::string::npos, message.find(name)) << name << " is not in: " << message;
  }
  EXPECT_EQ(std::string::npos, message.find("~noise_floor")) << message;

  const int reports = diagnostics.count();
  EXPECT_TRUE(waitUntil([&] { return diagnostics.count() > reports + 1; })) << "it died";
  EXPECT_EQ(0U, camera.imageSubscribers());
}

}  // namespace
}  // namespace line_plane_segmentation

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "bad_parameters_rostest");
  const ros::NodeHandle keeps_ros_running;
  return RUN_ALL_TESTS();
}
