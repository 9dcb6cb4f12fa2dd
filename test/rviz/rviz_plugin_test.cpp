// SPDX-License-Identifier: BSD-3-Clause
// rviz finds and loads the display of planes.
#include <gtest/gtest.h>
#include <ros/init.h>
#include <ros/node_handle.h>
#include <rviz/display.h>

#include <QApplication>
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
  // Neither is ever destroyed: the destructor of rviz's MessageFilterDisplay needs rviz's window.
  auto* const loader = new pluginlib::ClassLoader<rviz::Display>("rviz", "rviz::Display");
  rviz::Display* const display = loader->createUnmanagedInstance(kName);
  ASSERT_NE(nullptr, display);
  for (const char* property : {"Topic", "Color By", "Alpha", "Fill", "Outlines", "Normals", "Normal Length",
                               "Ids", "Covariance", "Covariance Scale"}) {
    EXPECT_NE(nullptr, display->subProp(property)->getParent()) << property;
  }
}

}  // namespace

// A display needs a node, and its properties an application.
int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "rviz_plugin_test");
  const ros::NodeHandle keeps_ros_running;
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
