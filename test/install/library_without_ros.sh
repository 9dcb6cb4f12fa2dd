#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds and installs the library without ROS, then a project that uses it; neither may find catkin.
# Usage: library_without_ros.sh SOURCE SCRATCH
set -euo pipefail
source_folder=$1
scratch=$2

rm -rf "$scratch"
mkdir -p "$scratch"
# Without the variables that a sourced workspace leaves: the example shall find what was installed here.
unset CMAKE_PREFIX_PATH ROS_PACKAGE_PATH
cmake -S "$source_folder" -B "$scratch/library" -DLPS_WITH_ROS=OFF -DCMAKE_DISABLE_FIND_PACKAGE_catkin=ON \
  -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0 -DBUILD_SHARED_LIBS=ON -DCMAKE_INSTALL_PREFIX="$scratch/installed"
cmake --build "$scratch/library" -- -j2
cmake --install "$scratch/library"

cmake -S "$source_folder/doc/examples/library" -B "$scratch/example" -DCMAKE_DISABLE_FIND_PACKAGE_catkin=ON \
  -DCMAKE_PREFIX_PATH="$scratch/installed"
cmake --build "$scratch/example"
"$scratch/example/find_planes"

# Nor may any header need more than is there; where ROS lies in /usr the compiler would find it.
cd "$scratch/installed/include"
if grep -rE '#include <(ros|[a-z_]+_msgs|line_plane_segmentation/(ros|simulation))/' .; then
  echo "these headers need what is not installed" >&2
  exit 1
fi
find line_plane_segmentation -name '*.h' -printf '#include <%p>\n' >"$scratch/all_headers.cpp"
eigen=$(sed -n 's|^Eigen3_DIR:PATH=\(.*\)/share/.*|\1/include/eigen3|p' "$scratch/example/CMakeCache.txt")
c++ -std=c++17 -fsyntax-only -I . -isystem "$eigen" "$scratch/all_headers.cpp"
