// SPDX-License-Identifier: BSD-3-Clause
#include "camera_path.h"

#include <cmath>
#include <cstddef>

#include "random.h"

namespace line_plane_segmentation::simulation {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// How far each of x, y, z, heading, elevation and roll swings [m, rad], how long that takes [s], and how
/// much it trembles [m, rad]. The times have no common period.
struct Habit {
  double amplitude;
  double period;
  double tremor;
};

constexpr std::array<Habit, 6> kHabits = {{{0.40, 17.0, 0.0010},
                                           {0.30, 23.0, 0.0010},
                                           {0.18, 13.0, 0.0010},
                                           {0.45, 19.0, 0.0015},
                                           {0.20, 11.0, 0.0015},
                                           {0.04, 7.0, 0.0010}}};

constexpr double kTremorPerSwing = 17.3;  // swings of the tremor during one of the slow ones

}  // namespace

double CameraPath::Sway::at(double seconds) const {
  const double angle = frequency * seconds + phase;
  return amplitude * std::sin(angle) + tremor * std::sin(kTremorPerSwing * angle);
}

CameraPath::CameraPath(const Eigen::Vector3d& station, const Eigen::Vector3d& target, std::uint64_t seed)
    : station_(station) {
  const Eigen::Vector3d line_of_sight = target - station;
  heading_ = std::atan2(line_of_sight.y(), line_of_sight.x());
  elevation_ = std::atan2(line_of_sight.z(), line_of_sight.head<2>().norm());
  Random random(seed);
  for (std::size_t i = 0; i < sways_.size(); ++i) {
    const Habit& habit = kHabits[i];
    sways_[i] = {habit.amplitude * random.uniform(0.8, 1.0), habit.tremor,
                 2.0 * kPi / (habit.period * random.uniform(0.9, 1.1)), random.uniform(0.0, 2.0 * kPi)};
  }
}

Eigen::Isometry3d CameraPath::pose(double seconds) const {
  const Eigen::Vector3d offset(sways_[0].at(seconds), sways_[1].at(seconds), sways_[2].at(seconds));
  return lookingAlong(station_ + offset, heading_ + sways_[3].at(seconds), elevation_ + sways_[4].at(seconds),
                      sways_[5].at(seconds));
}

Eigen::Isometry3d lookingAlong(const Eigen::Vector3d& position, double heading, double elevation,
                               double roll) {
  const Eigen::Vector3d forward(std::cos(elevation) * std::cos(heading),
                                std::cos(elevation) * std::sin(heading), std::sin(elevation));
  const Eigen::Vector3d right(std::sin(heading), -std::cos(heading), 0.0);
  Eigen::Matrix3d level;
  level << right, forward.cross(right), forward;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = position;
  pose.linear() = level * Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return pose;
}

}  // namespace line_plane_segmentation::simulation
