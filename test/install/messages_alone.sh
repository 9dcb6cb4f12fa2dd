#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds the messages alone, as on a laptop without PCL, and uses them from C++ and Python.
# Usage: messages_alone.sh SOURCE SCRATCH
set -euo pipefail
source_folder=$1
scratch=$2

rm -rf "$scratch"
mkdir -p "$scratch/devel/lib/python3/dist-packages"
without=()
for package in PCL OpenCV Boost pcl_ros nodelet rosbag_storage image_transport diagnostic_updater; do
  without+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=ON")
done
cmake -S "$source_folder" -B "$scratch" -DLPS_MESSAGES_ONLY=ON -DPYTHON_EXECUTABLE=/usr/bin/python3 \
  "${without[@]}" -DCMAKE_INSTALL_PREFIX="$scratch/installed" >"$scratch/configure.log" 2>&1 ||
  { tail -n 30 "$scratch/configure.log"; exit 1; }
cmake --build "$scratch" -- -j2 >"$scratch/build.log"
cmake --install "$scratch" >"$scratch/install.log"

unset PYTHONPATH ROS_PACKAGE_PATH CMAKE_PREFIX_PATH
(
  set +u
  [ ! -f /opt/ros/noetic/setup.bash ] || source /opt/ros/noetic/setup.bash
  cd "$scratch"
  PYTHONPATH=$scratch/devel/lib/python3/dist-packages:${PYTHONPATH:-} /usr/bin/python3 -c "
from line_plane_segmentation.msg import Plane, PlaneArray
message = PlaneArray(processing_seconds=0.5, planes=[Plane(hole_parts=[1])])
assert message.planes[0].hole_parts == [1]"
)
[ -f "$scratch/installed/include/line_plane_segmentation/PlaneArray.h" ]
[ ! -e "$scratch/devel/lib/libline_plane_segmentation_core.so" ]
cat >"$scratch/subscriber.cpp" <<'END'
#include <line_plane_segmentation/PlaneArray.h>
int main() { return line_plane_segmentation::PlaneArray().planes.empty() ? 0 : 1; }
END
c++ -std=c++17 -fsyntax-only -I "$scratch/devel/include" -isystem /opt/ros/noetic/include "$scratch/subscriber.cpp"
