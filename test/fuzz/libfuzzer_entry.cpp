// SPDX-License-Identifier: BSD-3-Clause
// What libFuzzer calls; LPS_FUZZ_TARGET is one of the functions of targets.h.
#include <gtest/gtest.h>

#include "targets.h"

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  testing::GTEST_FLAG(throw_on_failure) = true;
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  line_plane_segmentation::LPS_FUZZ_TARGET(data, size);
  return 0;
}
