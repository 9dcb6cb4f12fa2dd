// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/plane_tracker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "support/synthetic_depth.h"
#include "support/walls.h"

namespace line_plane_segmentation {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;
constexpr double kFrame = 1.0 / 30.0;  // [s]

/// Turned by so many degrees to the right, then moved.
Eigen::Isometry3d pose(double yaw, const Eigen::Vector3d& position = Eigen::Vector3d::Zero()) {
  return Eigen::Translation3d(position) * Eigen::AngleAxisd(yaw * M_PI / 180.0, Eigen::Vector3d::UnitY());
}

// A camera in a room: x right, y down, z ahead.
class Tracking : public testing::Test {
 protected:
  enum : std::size_t { kBack, kLeft, kRight, kFloor, kBox, kBoxTop };

  /// Takes the next picture and tracks its planes.
  void look(const Eigen::Isometry3d& camera_in_world, bool motion_known, double pause = kFrame) {
    seconds_ += pause;
    picture_ = pictureOf(walls_, camera_in_world, kinectCamera(width_, height_), width_, height_);
    const Eigen::Isometry3d motion = camera_in_world.inverse() * pose_;
    pose_ = camera_in_world;
    ids_ = tracker_.track(picture_.segmentation, kinectCamera(width_, height_), seconds_,
                          motion_known ? &motion : nullptr);
    ASSERT_EQ(picture_.segmentation.planes.size(), ids_.size());
    EXPECT_EQ(ids_.size(), std::set<std::uint32_t>(ids_.begin(), ids_.end()).size())
        << "an id twice in one image";
  }

  /// The wall's id in the last picture, 0 if it is not seen.
  std::uint32_t idOf(std::size_t wall) const {
    const int plane = picture_.planeOf(wall);
    return plane < 0 ? 0 : ids_[static_cast<std::size_t>(plane)];
  }

  std::vector<std::uint32_t> idsOfAll() const {
    std::vector<std::uint32_t> ids;
    for (std::size_t wall = 0; wall < walls_.size(); ++wall) ids.push_back(idOf(wall));
    return ids;
  }

  /// How many of the walls that are seen have another id than `before`.
  int changesSince(const std::vector<std::uint32_t>& before) const {
    int changes = 0;
    for (std::size_t wall = 0; wall < walls_.size(); ++wall) {
      if (idOf(wall) != 0 && idOf(wall) != before[wall]) ++changes;
    }
    return changes;
  }

  std::uint32_t newestId() const { return *std::max_element(ids_.begin(), ids_.end()); }

  int width_ = kWidth, height_ = kHeight;
  std::vector<Wall> walls_ = {
      {{-1.5, -2, 4}, {3, 0, 0}, {0, 3, 0}},       // back
      {{-1.5, -2, 0}, {0, 0, 4}, {0, 3, 0}},       // left
      {{1.5, -2, 0}, {0, 0, 4}, {0, 3, 0}},        // right
      {{-1.5, 1, 0}, {3, 0, 0}, {0, 0, 4}},        // floor
      {{-0.5, 0.5, 2.5}, {1, 0, 0}, {0, 0.5, 0}},  // a box's front
      {{-0.5, 0.5, 2.5}, {1, 0, 0}, {0, 0, 0.8}},  // and its top
  };
  PlaneTracker tracker_;
  WallPicture picture_;
  std::vector<std::uint32_t> ids_;
  Eigen::Isometry3d pose_ = Eigen::Isometry3d::Identity();
  double seconds_ = 1000.0;
};

TEST_F(Tracking, CountsFromOneAndKeepsIds) {
  look(pose(0), false);
  EXPECT_EQ(ids_, (std::vector<std::uint32_t>{1, 2, 3, 4, 5, 6}));
  for (int i = 0; i < 5; ++i) look(pose(0), false);
  EXPECT_EQ(ids_, (std::vector<std::uint32_t>{1, 2, 3, 4, 5, 6}));
}

// One degree a frame; as the camera turns the walls change their order of size.
TEST_F(Tracking, FollowsPlanesAndNotLabels) {
  for (const bool motion_known : {false, true}) {
    tracker_.reset();
    look(pose(-8), false);
    const std::vector<std::uint32_t> before = idsOfAll();
    const std::vector<std::size_t> order = picture_.wall_of;
    ASSERT_EQ(order.size(), 6U);
    for (int degrees = -7; degrees <= 8; ++degrees) look(pose(degrees), motion_known);
    EXPECT_EQ(idsOfAll(), before);
    EXPECT_NE(picture_.wall_of, order) << "nothing changed, nothing tested";
  }
}

TEST_F(Tracking, FollowsAKnownMotionHoweverSudden) {
  const Eigen::Isometry3d elsewhere = pose(25, {0.5, 0, 0.3});
  look(pose(0), true);
  const std::vector<std::uint32_t> before = idsOfAll();
  look(elsewhere, true);
  EXPECT_EQ(changesSince(before), 0);
  EXPECT_GE(ids_.size(), 5U);

  tracker_.reset();
  look(pose(0), false);
  look(elsewhere, false);
  EXPECT_GT(changesSince(before), 0) << "a motion that can be done without tests nothing";
}

TEST_F(Tracking, KnowsAPlaneAgainAfterAShortAbsence) {
  const double memory = TrackingParameters{}.track_memory;
  for (const bool motion_known : {false, true}) {
    look(pose(0), motion_known);
    const std::uint32_t id = idOf(kBox);
    for (const double absence : {0.3, memory - 0.2, memory + 0.2}) {
      walls_[kBox].there = false;
      look(pose(0), motion_known);
      EXPECT_EQ(idOf(kBox), 0U);
      look(pose(0), motion_known, absence - 2.0 * kFrame);
      walls_[kBox].there = true;
      look(pose(0), motion_known);
      if (absence < memory) {
        EXPECT_EQ(idOf(kBox), id) << absence << " s";
      } else {
        EXPECT_GT(idOf(kBox), id) << absence << " s";
      }
    }
    EXPECT_EQ(idOf(kBox), newestId()) << "an id is used again";
  }
}

// The right wall goes out of the picture. Coming back, other parts of it are seen than before.
TEST_F(Tracking, KnowsAPlaneAgainThatWasOutOfView) {
  walls_ = {walls_[kBack], walls_[kLeft], walls_[kRight]};
  look(pose(30), true);
  const std::uint32_t id = idOf(kRight);
  ASSERT_NE(id, 0U);
  for (int degrees = 30; degrees >= -30; degrees -= 2) look(pose(degrees), true);
  ASSERT_EQ(idOf(kRight), 0U);
  look(pose(40, {0, 0, 1.5}), true);
  EXPECT_EQ(idOf(kRight), id);
}

// The segmenter takes the box's front and top for one plane now and then.
TEST_F(Tracking, GivesBothTheirIdsBackAfterTheyWereSeenAsOne) {
  look(pose(0), false);
  const std::uint32_t front = idOf(kBox), top = idOf(kBoxTop);
  for (int round = 0; round < 5; ++round) {
    WallPicture merged = picture_;
    const auto from = static_cast<std::uint16_t>(merged.planeOf(kBoxTop) + 1);
    const auto to = static_cast<std::uint16_t>(merged.planeOf(kBox) + 1);
    ASSERT_EQ(from, merged.segmentation.planes.size()) << "the smallest: no other label has to change";
    std::replace(merged.segmentation.labels.begin(), merged.segmentation.labels.end(), from, to);
    merged.segmentation.planes.pop_back();
    ids_ = tracker_.track(merged.segmentation, kinectCamera(kWidth, kHeight), seconds_ += kFrame);
    EXPECT_EQ(idOf(kBox), front);
    look(pose(0), false);
    EXPECT_EQ(idOf(kBox), front);
    EXPECT_EQ(idOf(kBoxTop), top);
  }
}

// A pillar comes before the back wall. What was seen as one plane keeps its id while any part of it is seen.
TEST_F(Tracking, KeepsTheIdOfASurfaceInParts) {
  const Wall whole = walls_[kBack];
  const Wall large{{-0.5, -2, 4}, {2, 0, 0}, {0, 3, 0}}, small{{-1.5, -2, 4}, {0.7, 0, 0}, {0, 3, 0}};
  for (const bool motion_known : {false, true}) {
    tracker_.reset();
    walls_ = {small, large};
    look(pose(0), motion_known);
    EXPECT_EQ(idsOfAll(), (std::vector<std::uint32_t>{2, 1})) << "nobody has seen that they are one";
    walls_ = {whole};
    look(pose(0), motion_known);
    EXPECT_EQ(idsOfAll(), (std::vector<std::uint32_t>{1}));
    walls_ = {small, large};
    look(pose(0), motion_known);
    EXPECT_EQ(idsOfAll(), (std::vector<std::uint32_t>{2, 1}));
    walls_[1].there = false;
    look(pose(0), motion_known);
    EXPECT_EQ(idOf(0), 1U) << "it is what is left of the wall";
    walls_[1].there = true;
    look(pose(0), motion_known);
    EXPECT_EQ(idsOfAll(), (std::vector<std::uint32_t>{2, 1})) << "the larger part by far";
  }
}

TEST_F(Tracking, KeepsCoplanarThingsApartThatWereNeverSeenAsOne) {
  walls_ = {{{-0.5, -2, 4}, {2, 0, 0}, {0, 3, 0}}, {{-1.5, -2, 4}, {0.7, 0, 0}, {0, 3, 0}}};
  look(pose(0), true);
  walls_[0].there = false;
  look(pose(0), true);
  EXPECT_EQ(idOf(1), 2U);
  walls_[0].there = true;
  look(pose(0), true);
  EXPECT_EQ(idsOfAll(), (std::vector<std::uint32_t>{1, 2}));
}

TEST_F(Tracking, TakesNoOtherPlaneInTheSamePlaceForIt) {
  const Wall slanted{{-0.5, 0.3, 2.4}, {1, 0, 0}, {0, 0.3, 1.0}};     // turned by 73 degrees
  const Wall behind{{-0.65, 0.65, 3.25}, {1.3, 0, 0}, {0, 0.65, 0}};  // the same pixels, a third farther away
  for (const Wall& other : {slanted, behind}) {
    tracker_.reset();
    walls_ = {walls_[0], {{-0.5, 0.5, 2.5}, {1, 0, 0}, {0, 0.5, 0}}};
    look(pose(0), true);
    EXPECT_EQ(newestId(), 2U);
    walls_[1] = other;
    look(pose(0), true);
    ASSERT_EQ(ids_.size(), 2U);
    EXPECT_EQ(idOf(1), 3U);
  }
}

TEST_F(Tracking, DoesNotDependOnTheSizeOfTheImage) {
  look(pose(0), false);
  const std::vector<std::uint32_t> before = idsOfAll();
  for (const int width : {320, 80, 640, 160}) {
    width_ = width;
    height_ = width * 3 / 4;
    look(pose(1), false);
    EXPECT_EQ(idsOfAll(), before) << width;
  }
}

TEST_F(Tracking, BeginsAgainAfterAReset) {
  look(pose(0), false);
  walls_[kBack].there = false;
  look(pose(20), false);
  walls_[kBack].there = true;
  tracker_.reset();
  seconds_ = 3.0;
  look(pose(0), false);
  EXPECT_EQ(ids_, (std::vector<std::uint32_t>{1, 2, 3, 4, 5, 6}));
}

TEST_F(Tracking, GivesLabelsWhileItIsOff) {
  look(pose(-8), false);
  TrackingParameters parameters;
  parameters.track_planes = false;
  tracker_.setParameters(parameters);
  for (const double yaw : {8, 0, -8}) {
    look(pose(yaw), false);
    EXPECT_EQ(ids_, (std::vector<std::uint32_t>{1, 2, 3, 4, 5, 6}));
  }
}

TEST_F(Tracking, GoesByItsBounds) {
  TrackingParameters parameters;
  parameters.track_angle = 10.0;
  tracker_.setParameters(parameters);
  walls_ = {walls_[kBack]};
  look(pose(0), false);
  look(pose(9), false);
  EXPECT_EQ(ids_.front(), 1U);
  look(pose(20), false);
  EXPECT_EQ(ids_.front(), 2U);

  tracker_.reset();
  parameters = {};
  parameters.track_distance = 0.05;
  tracker_.setParameters(parameters);
  look(pose(0), false);
  look(pose(0, {0, 0, 0.15}), false);
  EXPECT_EQ(ids_.front(), 1U);
  look(pose(0, {0, 0, 0.4}), false);
  EXPECT_EQ(ids_.front(), 2U);
}

TEST_F(Tracking, GivesTheSameIdsForTheSameInput) {
  const auto run = [this] {
    tracker_ = PlaneTracker();
    pose_ = pose(0);
    seconds_ = 1000.0;
    for (Wall& wall : walls_) wall.there = true;
    std::vector<std::vector<std::uint32_t>> all;
    for (int i = 0; i < 30; ++i) {
      walls_[static_cast<std::size_t>(i % 6)].there = i % 5 != 0;
      look(pose(7 * (i % 4)), i % 3 == 0);
      all.push_back(ids_);
    }
    return all;
  };
  const auto first = run();
  EXPECT_EQ(run(), first);
}

}  // namespace
}  // namespace line_plane_segmentation
