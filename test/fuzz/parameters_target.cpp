// SPDX-License-Identifier: BSD-3-Clause
#include <dynamic_reconfigure/config_tools.h>
#include <gtest/gtest.h>

#include <boost/make_shared.hpp>
#include <string>
#include <type_traits>
#include <vector>

#include "drawn_scene.h"
#include "frame_run.h"
#include "line_plane_segmentation/ros/parameter_config.h"
#include "ros/test_messages.h"
#include "targets.h"

namespace line_plane_segmentation {
namespace {

using dynamic_reconfigure::ConfigTools;

// Any value that the type has.
template <typename T>
T drawAny(ByteReader& bytes) {
  return bytes.awkward<T>();
}
template <>
bool drawAny(ByteReader& bytes) {
  return bytes.chance(128);
}
template <>
Method drawAny(ByteReader& bytes) {
  return static_cast<Method>(bytes.awkward<int>());
}

struct AnyValueDrawer {
  template <typename T, typename Bound>
  void operator()(const char* name, T& value, Bound, Bound) {
    if (index-- != 0) return;
    value = drawAny<T>(bytes);
    drawn_name = name;
  }
  int index;
  ByteReader& bytes;
  std::string drawn_name = {};
};

void expectWithinBounds(const Parameters& parameters) {
  visitParameters(parameters, [](const char* name, auto value, auto min, auto max) {
    using T = std::decay_t<decltype(value)>;
    EXPECT_TRUE(value >= static_cast<T>(min) && value <= static_cast<T>(max)) << name;
  });
  EXPECT_LT(parameters.scanlines.min_range, parameters.scanlines.max_range);
  EXPECT_EQ(1, parameters.candidates.points_per_segment % 2);
  EXPECT_NE(1, parameters.lines.line_window);
}

std::vector<double> valuesOf(const NodeletParameters& parameters) {
  std::vector<double> values;
  visitNodeletParameters(parameters, [&](const char*, const auto& value, auto, auto) {
    values.push_back(static_cast<double>(value));
  });
  return values;
}

// Where a parameter is 0 for "from the image's width", there is one for every width.
void expectResolvable(const Parameters& parameters, int width) {
  const Parameters p = resolve(parameters, width);
  for (const int value : {p.scanlines.scanline_spacing, p.lines.line_window, p.lines.min_line_points,
                          p.candidates.normal_window, p.candidates.min_window_points,
                          p.extraction.min_plane_inliers, p.cleanup.min_region_pixels}) {
    EXPECT_GE(value, 1) << "at width " << width;
  }
}

// As a library's user may set them.
Parameters drawByHand(ByteReader& bytes) {
  Parameters parameters;
  for (int i = bytes.integer(0, 12); i > 0; --i) {
    AnyValueDrawer drawer{bytes.integer(0, 33), bytes};
    visitParameters(parameters, drawer);
  }
  sanitize(parameters);
  expectWithinBounds(parameters);
  EXPECT_TRUE(sanitize(parameters).empty()) << "what is in order stays as it is";
  return parameters;
}

// As the command line sets them.
Parameters drawAsText(ByteReader& bytes) {
  constexpr const char* kTexts[] = {"nan",    "inf",  "-inf",  "1e999", "-1", "0",
                                    "1e-400", "true", "paper", "",      "  ", "0x10"};
  Parameters parameters;
  for (int i = bytes.integer(0, 6); i > 0; --i) {
    AnyValueDrawer drawer{bytes.integer(0, 33), bytes};
    Parameters unused;
    visitParameters(unused, drawer);
    std::string text = kTexts[bytes.integer(0, 11)];
    if (bytes.chance(128)) {
      text.assign(static_cast<std::size_t>(bytes.integer(0, 20)), ' ');
      for (char& letter : text) letter = static_cast<char>(bytes.raw<std::uint8_t>());
    }
    const std::string problem = setParameter(drawer.drawn_name, text, parameters);
    EXPECT_LT(problem.size(), 200U);
    visitParameters(parameters, [](const char* name, auto value, auto min, auto max) {
      using T = std::decay_t<decltype(value)>;
      EXPECT_TRUE(value >= static_cast<T>(min) && value <= static_cast<T>(max)) << name;
    });
  }
  sanitize(parameters);
  return parameters;
}

// As requests to a running nodelet set them; the server has clamped them when they come.
Parameters drawAsRequests(ByteReader& bytes) {
  constexpr const char* kPresets[] = {"kinect", "short_range", "paper", "custom", "", "none"};
  constexpr const char* kFrames[] = {"", "/", "map", "/map", "//"};
  NodeletParameters current;
  PlaneSegmenterConfig config = PlaneSegmenterConfig::__getDefault__();
  for (int request = bytes.integer(1, 3); request > 0; --request) {
    NodeletParameters wanted = parametersFrom(config);
    for (int i = bytes.integer(0, 6); i > 0; --i) {
      AnyValueDrawer drawer{bytes.integer(0, 47), bytes};
      visitNodeletParameters(wanted, drawer);
    }
    if (bytes.chance(64)) wanted.preset = kPresets[bytes.integer(0, 5)];
    if (bytes.chance(64)) wanted.location.frames.gravity_frame = kFrames[bytes.integer(0, 4)];
    writeParameters(wanted, config);
    config.__clamp__();

    std::vector<std::string> changes;
    current = reconfigured(current, config, changes);
    expectWithinBounds(current.method);
    EXPECT_EQ(valuesOf(current), valuesOf(parametersFrom(config))) << "the client is told something else";
    changes.clear();
    const NodeletParameters again = reconfigured(current, config, changes);
    EXPECT_EQ(valuesOf(current), valuesOf(again));
    EXPECT_EQ(current.preset, again.preset);
  }
  return current.method;
}

CameraFrame frameOf(const DrawnScene& scene, ByteReader& bytes) {
  CameraFrame frame;
  frame.image = boost::make_shared<sensor_msgs::Image>(imageOf(scene, bytes));
  frame.info = boost::make_shared<sensor_msgs::CameraInfo>(testInfo(scene.width, scene.height));
  return frame;
}

}  // namespace

void tryParameters(const std::uint8_t* data, std::size_t size) {
  ByteReader bytes(data, size);
  const int way = bytes.integer(0, 2);
  const Parameters parameters = way == 0   ? drawByHand(bytes)
                                : way == 1 ? drawAsText(bytes)
                                           : drawAsRequests(bytes);
  // As wide as an image of 16 bits may be by InputLimits.
  expectResolvable(parameters, 1 + static_cast<int>(bytes.raw<std::uint32_t>() % (1U << 24)));
  FrameRun run(parameters);
  const CameraFrame frame = frameOf(drawScene(bytes), bytes);
  run.process(frame, bytes);
  run.expectRepeatable(frame);
}

}  // namespace line_plane_segmentation
