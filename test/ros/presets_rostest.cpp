// SPDX-License-Identifier: BSD-3-Clause
// Presets, set before the start and at run time.
#include <dynamic_reconfigure/Config.h>
#include <gtest/gtest.h>

#include "line_plane_segmentation/parameters.h"
#include "reconfigure.h"
#include "test_camera.h"

namespace line_plane_segmentation {
namespace {

class Presets : public testing::Test {
 protected:
  Presets() {
    subscriber_ = nh_.subscribe<dynamic_reconfigure::Config>(
        "plane_segmenter/parameter_updates", 10,
        [this](const dynamic_reconfigure::Config::ConstPtr& message) {
          dynamic_reconfigure::Config copy = *message;
          config_.__fromMessage__(copy);
        });
  }

  ros::NodeHandle nh_;
  ros::Subscriber subscriber_;
  PlaneSegmenterConfig config_;
};

// Order matters: the first test is about the start.
TEST_F(Presets, fillInWhatNobodySet) {
  Parameters preset;
  ASSERT_TRUE(loadPreset("short_range", preset));
  // The first update has what is on the parameter server, the next one what the segmenter makes of it.
  ASSERT_TRUE(waitUntil([this] { return config_.gravity_frame == "world" && config_.preset == "custom"; }))
      << config_.preset;
  EXPECT_EQ(preset.noise.floor, config_.noise_floor);
  EXPECT_EQ(preset.scanlines.min_range, config_.min_range);
  EXPECT_EQ(0, config_.min_plane_inliers);
  EXPECT_EQ(static_cast<int>(Method::kPaper), config_.method) << "set by its name";
}

TEST_F(Presets, areLoadedWhileItRuns) {
  for (const char* name : {"paper", "short_range", "kinect"}) {
    Parameters preset;
    ASSERT_TRUE(loadPreset(name, preset));
    dynamic_reconfigure::Reconfigure call;
    setString(call, "preset", name);
    reconfigure(call);
    ASSERT_TRUE(waitUntil([&] { return config_.preset == name; }));
    EXPECT_EQ(static_cast<int>(preset.method), config_.method) << name;
    EXPECT_EQ(preset.noise.floor, config_.noise_floor) << name;
    EXPECT_EQ(preset.extraction.min_plane_inliers, config_.min_plane_inliers) << name;
    EXPECT_EQ("world", config_.gravity_frame) << name;
  }
}

}  // namespace
}  // namespace line_plane_segmentation
