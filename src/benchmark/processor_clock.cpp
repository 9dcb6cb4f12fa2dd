// SPDX-License-Identifier: BSD-3-Clause
#include "processor_clock.h"

#include <ctime>

namespace line_plane_segmentation {

double processorMilliseconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

}  // namespace line_plane_segmentation
