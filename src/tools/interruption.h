// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace line_plane_segmentation {

/// After this call SIGINT (Ctrl-C), SIGTERM, SIGHUP and SIGQUIT no longer end the program at once, so that it
/// can finish orderly. The program has to call stopIfInterrupted() regularly. A second signal of the same
/// kind ends it.
void catchInterruption();

/// @throws BadInput if one of these signals was received
void stopIfInterrupted();

}  // namespace line_plane_segmentation
