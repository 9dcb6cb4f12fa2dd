// SPDX-License-Identifier: BSD-3-Clause
// rviz finds and loads the display of planes.
#include <gtest/gtest.h>
#include <rviz/display.h>

#include <algorithm>
#include <pluginlib/class_loader.hpp>
#include <string>
#include <vector>

namespace {

constexpr char kName[] = "line_plane_segmentation/PlaneArray";

TEST(RvizPlugin, isDeclaredAndLoads) {
  pluginlib::ClassLoader<rviz::Display> loader("rviz", "rviz::Display");
  const std::vector<std::string> names = loader.getDeclaredClasses();
  ASSERT_NE(names.end(), std::find(names.begin(), names.end(), kName));
  ASSERT_NO_THROW(loader.loadLibraryForClass(kName));
  EXPECT_TRUE(loader.isClassLoaded(kName));
}

TEST(RvizPlugin, hasTheDocumentedProperties) {
  pluginlib::ClassLoader<rviz::Display> loader("rviz", "rviz::Display");
  const boost::shared_ptr<rviz::Display> display = loader.createInstance(kName);
  ASSERT_NE(nullptr, display);
  for (const char* property : {"Topic", "Color By", "Alpha", "Fill", "Outlines", "Normals", "Normal Length",
                               "Ids", "Covariance", "Covariance Scale"}) {
    EXPECT_NE(nullptr, display->subProp(property)->getParent()) << property;
  }
}

}  // namespace
