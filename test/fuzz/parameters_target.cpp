// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>
#include <type_traits>
#include <vector>

#include "drawn_parameters.h"
#include "drawn_scene.h"
#include "frame_run.h"
#include "parameter_config.h"
#include "ros/test_messages.h"
#include "targets.h"

namespace line_plane_segmentation {
namespace {

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

template <typename Visit>
void drawAnyOne(ByteReader& bytes, Visit visit) {
  actOnOne(bytes, visit, [&](const char*, auto& value, auto, auto) {
    value = drawAny<std::decay_t<decltype(value)>>(bytes);
  });
}

void expectEachWithinBounds(const Parameters& parameters) {
  visitParameters(parameters, [](const char* name, auto value, auto min, auto max) {
    using T = std::decay_t<decltype(value)>;
    EXPECT_TRUE(value >= static_cast<T>(min) && value <= static_cast<T>(max)) << name;
  });
}

void expectInOrder(const Parameters& parameters) {
  expectEachWithinBounds(parameters);
  EXPECT_LT(parameters.scanlines.min_range, parameters.scanlines.max_range);
  EXPECT_EQ(1, parameters.candidates.points_per_segment % 2);
  EXPECT_NE(1, parameters.lines.line_window);
}

void expectSame(const NodeletParameters& expected, const NodeletParameters& parameters) {
  const auto values_of = [](const NodeletParameters& all) {
    std::vector<double> values;
    visitNodeletParameters(all, [&](const char*, const auto& value, auto, auto) {
      values.push_back(static_cast<double>(value));
    });
    return values;
  };
  const auto texts_of = [](const NodeletParameters& all) {
    std::vector<std::string> texts{all.preset};
    visitTexts(all, [&](const char*, const std::string& frame) { texts.push_back(frame); });
    return texts;
  };
  EXPECT_EQ(values_of(expected), values_of(parameters));
  EXPECT_EQ(texts_of(expected), texts_of(parameters));
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
    drawAnyOne(bytes, [&](auto visitor) { visitParameters(parameters, visitor); });
  }
  sanitize(parameters);
  expectInOrder(parameters);
  EXPECT_TRUE(sanitize(parameters).empty()) << "what is in order stays as it is";
  return parameters;
}

// As the command line sets them.
Parameters drawAsText(ByteReader& bytes) {
  constexpr const char* kTexts[] = {"nan",    "inf",  "-inf",  "1e999", "-1", "0",
                                    "1e-400", "true", "paper", "",      "  ", "0x10"};
  Parameters parameters;
  for (int i = bytes.integer(0, 6); i > 0; --i) {
    std::string name;
    actOnOne(
        bytes, [&](auto visitor) { visitParameters(parameters, visitor); },
        [&](const char* drawn, auto&, auto, auto) { name = drawn; });
    std::string text = kTexts[bytes.integer(0, 11)];
    if (bytes.chance(128)) {
      text.assign(static_cast<std::size_t>(bytes.integer(0, 20)), ' ');
      for (char& letter : text) letter = static_cast<char>(bytes.raw<std::uint8_t>());
    }
    const std::string problem = setParameter(name, text, parameters);
    EXPECT_LT(problem.size(), 200U);
    expectEachWithinBounds(parameters);
  }
  sanitize(parameters);
  expectInOrder(parameters);
  return parameters;
}

// As requests to a running nodelet set them; the server has clamped them when they come.
Parameters drawAsRequests(ByteReader& bytes) {
  constexpr const char* kPresets[] = {"kinect", "short_range", "paper",        "custom", "",
                                      "none",   "stereo",      "stereo_short", "tof"};
  constexpr const char* kFrames[] = {"", "/", "map", "/map", "//"};
  NodeletParameters current;
  PlaneSegmenterConfig config = PlaneSegmenterConfig::__getDefault__();
  for (int request = bytes.integer(1, 3); request > 0; --request) {
    NodeletParameters wanted = parametersFrom(config);
    for (int i = bytes.integer(0, 6); i > 0; --i) {
      drawAnyOne(bytes, [&](auto visitor) { visitNodeletParameters(wanted, visitor); });
    }
    if (bytes.chance(64)) wanted.preset = kPresets[bytes.integer(0, 8)];
    visitFrames(wanted, [&](const char*, std::string& frame) {
      if (bytes.chance(64)) frame = kFrames[bytes.integer(0, 4)];
    });
    writeParameters(wanted, config);
    config.__clamp__();

    std::vector<std::string> changes;
    current = reconfigured(current, config, changes);
    expectInOrder(current.method);
    {
      SCOPED_TRACE("what the client is told");
      expectSame(current, parametersFrom(config));
    }
    SCOPED_TRACE("the same request again");
    expectSame(current, reconfigured(current, config, changes));
  }
  return current.method;
}

}  // namespace

void tryParameters(const std::uint8_t* data, std::size_t size) {
  ByteReader bytes(data, size);
  const int way = bytes.integer(0, 2);
  const Parameters parameters = way == 0   ? drawByHand(bytes)
                                : way == 1 ? drawAsText(bytes)
                                           : drawAsRequests(bytes);
  // As wide as an image of 16 bits may be by InputLimits.
  expectResolvable(parameters, 1 + static_cast<int>(bytes.raw<std::uint32_t>() % InputLimits{}.max_pixels));
  FrameRun run(parameters);
  const DrawnScene scene = drawScene(bytes);
  const InputFrame frame = frameOf(imageOf(scene, bytes), testInfo(scene.width, scene.height));
  run.process(frame, bytes);
  run.expectRepeatable(frame);
}

}  // namespace line_plane_segmentation
