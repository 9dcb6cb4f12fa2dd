// SPDX-License-Identifier: BSD-3-Clause
// The main function of every test program: catkin links gtest without one.
#include <gtest/gtest.h>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
