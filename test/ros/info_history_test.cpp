// SPDX-License-Identifier: BSD-3-Clause
#include "info_history.h"

#include <gtest/gtest.h>

#include "stamped_messages.h"

namespace line_plane_segmentation {
namespace {

TEST(InfoHistory, remembersTheCalibrationWhenStampsAreForgotten) {
  InfoHistory infos;
  infos.add(infoAt(1.0), {});
  infos.clearStamps();
  EXPECT_FALSE(infos.find(ros::Time(1.0)));
  EXPECT_TRUE(infos.newestFor(*imageAt(50.0).image, true));
}

TEST(InfoHistory, sharesWhatDoesNotChange) {
  InfoHistory infos;
  const auto first = infoAt(1.0);
  infos.add(first, {});
  infos.add(infoAt(2.0), {});
  const auto changed = infoAt(3.0);
  changed->K[0] = 500.0;
  infos.add(changed, {});
  EXPECT_EQ(first, infos.find(ros::Time(2.0)));
  EXPECT_EQ(changed, infos.find(ros::Time(3.0)));
  EXPECT_EQ(changed, infos.newestFor(*imageAt(0.0).image, true));
}

TEST(InfoHistory, isBounded) {
  InfoHistory infos(std::chrono::seconds(1000), 3);
  for (const double stamp : {1.0, 2.0, 3.0, 4.0}) infos.add(infoAt(stamp), {});
  EXPECT_FALSE(infos.find(ros::Time(1.0)));
  EXPECT_TRUE(infos.find(ros::Time(2.0)));
}

}  // namespace
}  // namespace line_plane_segmentation
