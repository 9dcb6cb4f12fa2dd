// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <rosgraph_msgs/Log.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "reconfigure.h"
#include "test_camera.h"

namespace line_plane_segmentation {

/// Reports of a segmenter on /diagnostics.
class Diagnostics {
 public:
  explicit Diagnostics(const std::string& segmenter = "plane_segmenter")
      : name_(segmenter + ": plane segmentation"),
        subscriber_(ros::NodeHandle().subscribe<diagnostic_msgs::DiagnosticArray>(
            "/diagnostics", 100,
            [this](const diagnostic_msgs::DiagnosticArray::ConstPtr& message) { take(*message); })) {}
  Diagnostics(const Diagnostics&) = delete;
  Diagnostics& operator=(const Diagnostics&) = delete;

  /// Number of received reports.
  int count() const { return count_; }
  const diagnostic_msgs::DiagnosticStatus& newest() const { return newest_; }

  /// Value of the newest report, "" if absent.
  std::string value(const std::string& key) const {
    const auto found = std::find_if(newest_.values.begin(), newest_.values.end(),
                                    [&](const diagnostic_msgs::KeyValue& value) { return value.key == key; });
    return found == newest_.values.end() ? std::string() : found->value;
  }

  /// Number in the newest report, -1 if absent.
  double number(const std::string& key) const {
    const std::string text = value(key);
    return text.empty() ? -1.0 : std::stod(text);
  }

  /// Waits for a report of this level that contains the text.
  bool waitForStatus(int level, const std::string& text, double seconds = 15.0) const {
    return waitUntil(
        [&] { return newest_.level == level && newest_.message.find(text) != std::string::npos; }, seconds);
  }

  bool waitForValue(const std::string& key, const std::string& expected) const {
    return waitUntil([&] { return value(key) == expected; });
  }

  /// Waits for a report that covers everything until now.
  bool waitForReport() const {
    // The next one may have been made earlier.
    const int before = count_;
    return waitUntil([&] { return count_ >= before + 2; });
  }

 private:
  void take(const diagnostic_msgs::DiagnosticArray& message) {
    for (const auto& status : message.status) {
      if (status.name != name_) continue;
      newest_ = status;
      ++count_;
    }
  }

  std::string name_;
  diagnostic_msgs::DiagnosticStatus newest_;
  int count_ = 0;
  ros::Subscriber subscriber_;
};

/// Log lines of the segmenter under test.
class LogLines {
 public:
  LogLines()
      : subscriber_(ros::NodeHandle().subscribe<rosgraph_msgs::Log>(
            "/rosout", 1000, [this](const rosgraph_msgs::Log::ConstPtr& line) {
              if (line->msg.find("[/plane_segmenter]") != std::string::npos) lines_.push_back(*line);
            })) {
    // Messages before the connection is established are lost: a harmless one is logged repeatedly until it
    // arrives.
    const auto ask_for_an_even_number = [](PlaneSegmenterConfig& config) { config.points_per_segment = 4; };
    EXPECT_TRUE(waitUntil([&] {
      reconfigure(ask_for_an_even_number);
      spinFor(0.1);
      return !lines_.empty();
    })) << "the log is not heard";
    reconfigure([](PlaneSegmenterConfig&) {});
  }
  LogLines(const LogLines&) = delete;
  LogLines& operator=(const LogLines&) = delete;

  /// Number of warnings so far that contain the text.
  int warnings(const std::string& text) const {
    return static_cast<int>(std::count_if(lines_.begin(), lines_.end(), [&](const rosgraph_msgs::Log& line) {
      return line.level == rosgraph_msgs::Log::WARN && line.msg.find(text) != std::string::npos;
    }));
  }

 private:
  std::vector<rosgraph_msgs::Log> lines_;
  ros::Subscriber subscriber_;
};

}  // namespace line_plane_segmentation
