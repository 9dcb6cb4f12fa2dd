// SPDX-License-Identifier: BSD-3-Clause
#include "interruption.h"

#include <csignal>

#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

// The only kind of variable that a signal handler may write.
volatile std::sig_atomic_t interrupted = 0;

// The second signal ends the program at once, in case it is stuck.
void remember(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void catchInterruption() {
  for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGTERM}) {
    // Signals that are ignored stay ignored: nohup ignores SIGHUP.
    if (std::signal(signal, remember) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
}

void stopIfInterrupted() {
  if (interrupted != 0) throw BadInput("interrupted");
}

}  // namespace line_plane_segmentation
