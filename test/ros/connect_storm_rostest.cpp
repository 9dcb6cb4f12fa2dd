// SPDX-License-Identifier: BSD-3-Clause
// Row 32: subscribers connect and disconnect a hundred times per second while images arrive, on each output
// in turn and on all at once. Afterwards the state of the segmenter matches the remaining subscribers.
#include <gtest/gtest.h>
#include <line_plane_segmentation/PlaneArray.h>

#include <deque>
#include <string>
#include <vector>

#include "any_output.h"
#include "test_camera.h"

namespace line_plane_segmentation {
namespace {

class ConnectStorm : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(ros::service::waitForService("plane_segmenter/set_parameters", 15000));
  }

  void publishNext() { camera_.publish(image_, info_, ros::Time(seconds_ += 0.1)); }

  // Ten subscribers of each of these outputs connect and disconnect within 100 ms, most of them before
  // their connection is established. One stays for about 0.4 s, the time that establishing a connection
  // takes.
  void storm(const std::vector<std::string>& outputs, double stay) {
    std::deque<Anything> subscribers;
    for (int i = 0; i < 10; ++i) {
      for (const std::string& output : outputs) subscribers.emplace_back("plane_segmenter/" + output);
      while (subscribers.size() > 3 * outputs.size()) subscribers.pop_front();
      publishNext();
      spinFor(0.01);
    }
    spinFor(stay);
  }

  TestCamera camera_;
  sensor_msgs::Image image_ = imageOfPlane(320, 240, "16UC1", Eigen::Vector3d(0.0, 0.0, -1.0), 1.5);
  sensor_msgs::CameraInfo info_ = testInfo(320, 240);
  double seconds_ = 1000.0;
};

TEST_F(ConnectStorm, endsInTheStateThatIsWanted) {
  double stay = 0.25;  // [s]
  for (int round = 0; round < 2; ++round) {
    const int arrivals = camera_.arrivals();
    for (const std::string& output : outputs()) {
      storm({output}, stay);
      stay += 0.02;
    }
    storm(outputs(), stay);
    EXPECT_TRUE(camera_.waitForIdle());
    EXPECT_GT(camera_.arrivals(), arrivals) << "not one of them was noticed";

    const Inbox<PlaneArray> planes("plane_segmenter/planes");
    EXPECT_TRUE(camera_.waitForSubscriber());
    publishNext();
    EXPECT_TRUE(planes.waitFor(ros::Time(seconds_)));
    EXPECT_EQ(1U, planes.newest()->planes.size());
  }
}

}  // namespace
}  // namespace line_plane_segmentation
