// SPDX-License-Identifier: BSD-3-Clause
#include "contain_exceptions.h"

#include <gtest/gtest.h>

#include <new>

namespace line_plane_segmentation {
namespace {

TEST(ContainExceptions, LetsNoneThrough) {
  containExceptions("test", [] { throw std::bad_alloc(); });
  containExceptions("test", [] { throw 1; });
  bool called = false;
  containExceptions("test", [&] { called = true; });
  EXPECT_TRUE(called);
}

}  // namespace
}  // namespace line_plane_segmentation
