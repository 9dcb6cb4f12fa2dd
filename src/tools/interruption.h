// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace line_plane_segmentation {

/// From here on Ctrl-C, and a request to end, no longer end the program on the spot, so that it can take away
/// what it has half written: it has to call stopIfInterrupted() now and then.
void catchInterruption();

/// @throws BadInput if the program was asked to end
void stopIfInterrupted();

}  // namespace line_plane_segmentation
