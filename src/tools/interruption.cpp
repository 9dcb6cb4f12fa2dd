// SPDX-License-Identifier: BSD-3-Clause
#include "interruption.h"

#include <csignal>

#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

// A signal handler can write to nothing but such a variable.
volatile std::sig_atomic_t interrupted = 0;

void remember(int /*signal*/) { interrupted = 1; }

}  // namespace

void catchInterruption() {
  std::signal(SIGINT, remember);
  std::signal(SIGTERM, remember);
}

void stopIfInterrupted() {
  if (interrupted != 0) throw BadInput("interrupted");
}

}  // namespace line_plane_segmentation
