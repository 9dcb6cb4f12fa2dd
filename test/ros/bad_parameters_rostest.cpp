// SPDX-License-Identifier: BSD-3-Clause
// Started with invalid parameters, the segmenter stays alive and idle, and reports what is wrong.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "test_reports.h"

namespace line_plane_segmentation {
namespace {

TEST(BadParameters, areNamedInTheDiagnostics) {
  const TestCamera camera;
  const Diagnostics diagnostics;
  ASSERT_TRUE(diagnostics.waitForStatus(diagnostic_msgs::DiagnosticStatus::ERROR, ""));
  const std::string message = diagnostics.newest().message;
  for (const char* complaint : {"~plane_distance = nan is not within", "~max_range = -3 is not within",
                                "~trace_outlines must be true or false", "~method must be adaptive or paper",
                                "~min_patches must be a whole number", "~target_frame must be a text"}) {
    EXPECT_NE(std::string::npos, message.find(complaint)) << complaint << " is not in: " << message;
  }
  EXPECT_EQ(std::string::npos, message.find("~noise_floor")) << message;

  const int reports = diagnostics.count();
  EXPECT_TRUE(waitUntil([&] { return diagnostics.count() > reports + 1; })) << "it died";
  EXPECT_EQ(0U, camera.imageSubscribers());
}

TEST(BadParameters, thoseThatCountOnlyAtTheStartAreNamedToo) {
  const std::pair<const char*, const char*> cases[] = {
      {"input_of_no_such_name", "~input must be image or cloud"},
      {"input_of_wrong_type", "~input must be image or cloud"},
      {"queue_of_wrong_type", "~queue_size must be a whole number"},
      {"queue_too_short", "~queue_size must be a whole number"},
      {"too_many_pixels", "~max_pixels must be a whole number"},
      {"matching_of_no_such_name", "~info_matching must be exact, latest or auto"},
      {"unit_that_is_no_number", "~depth_unit must be a number from 1e-06 to 0.1"},
      {"period_that_is_no_number", "~diagnostic_period must be a number"}};
  for (const auto& [segmenter, complaint] : cases) {
    const Diagnostics diagnostics(segmenter);
    EXPECT_TRUE(diagnostics.waitForStatus(diagnostic_msgs::DiagnosticStatus::ERROR, complaint))
        << segmenter << ": " << diagnostics.newest().message;
  }
}

}  // namespace
}  // namespace line_plane_segmentation
