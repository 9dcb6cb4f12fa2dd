// SPDX-License-Identifier: BSD-3-Clause
#include "log_exceptions.h"

#include <gtest/gtest.h>

#include <new>

namespace line_plane_segmentation {
namespace {

TEST(LogExceptions, LetsNoneThrough) {
  logExceptions("test", [] { throw std::bad_alloc(); });
  logExceptions("test", [] { throw 1; });
  bool called = false;
  logExceptions("test", [&] { called = true; });
  EXPECT_TRUE(called);
}

}  // namespace
}  // namespace line_plane_segmentation
