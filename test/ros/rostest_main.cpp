// SPDX-License-Identifier: BSD-3-Clause
// Main function of all rostests. The node is named after its program.
#include <gtest/gtest.h>
#include <ros/init.h>
#include <ros/node_handle.h>

#include <filesystem>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, std::filesystem::path(argv[0]).filename().string());
  const ros::NodeHandle keeps_ros_running;
  return RUN_ALL_TESTS();
}
