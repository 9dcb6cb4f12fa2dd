#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds the library without ROS as a part of another project, installs it from there, then builds projects that use
# the installed one; none of them may find catkin.
# Usage: library_without_ros.sh SOURCE SCRATCH
set -euo pipefail
source_folder=$1
scratch=$2

rm -rf "$scratch"
mkdir -p "$scratch"
# Without the variables that a sourced workspace leaves: the example shall find what was installed here.
unset CMAKE_PREFIX_PATH ROS_PACKAGE_PATH

# By default a parent project installs nothing of the library.
cmake -S "$source_folder/test/install/parent" -B "$scratch/fetched" -DLIBRARY_SOURCE="$source_folder" -DFETCH=ON
cmake --install "$scratch/fetched" --prefix "$scratch/nothing"
[ ! -e "$scratch/nothing" ]

# Not optimised, so that as little as possible is inlined and as much as possible shared with programs.
cmake -S "$source_folder/test/install/parent" -B "$scratch/parent" -DLIBRARY_SOURCE="$source_folder" -DLPS_INSTALL=ON \
  -DCMAKE_CXX_FLAGS=-O0 -DBUILD_SHARED_LIBS=ON -DCMAKE_INSTALL_PREFIX="$scratch/installed"
cmake --build "$scratch/parent" -- -j2
"$scratch/parent/find_planes"
cmake --install "$scratch/parent"
[ -n "$(find "$scratch/installed" -name libline_plane_segmentation_core.so.0.1)" ]

cmake -S "$source_folder/doc/examples/library" -B "$scratch/example" -DCMAKE_DISABLE_FIND_PACKAGE_catkin=ON \
  -DCMAKE_PREFIX_PATH="$scratch/installed"
cmake --build "$scratch/example"
"$scratch/example/find_planes"
bash "$source_folder/test/install/flags/compare.sh" "$source_folder" "$scratch/installed" "$scratch/flags"

# Nor may any header need more than is there; where ROS lies in /usr the compiler would find it.
cd "$scratch/installed/include"
if grep -rE '#include <(ros|[a-z_]+_msgs)/' .; then
  echo "these headers need what is not installed" >&2
  exit 1
fi
find line_plane_segmentation -name '*.h' -printf '#include <%p>\n' >"$scratch/all_headers.cpp"
eigen=$(sed -n 's|^Eigen3_DIR:PATH=\(.*\)/share/.*|\1/include/eigen3|p' "$scratch/example/CMakeCache.txt")
c++ -std=c++17 -fsyntax-only -I . -isystem "$eigen" "$scratch/all_headers.cpp"

# Where catkin is missing the package is configured with all that needs no ROS, by its own decision.
cmake -S "$source_folder" -B "$scratch/no_catkin" -DCMAKE_DISABLE_FIND_PACKAGE_catkin=ON \
  -DPYTHON_EXECUTABLE=/usr/bin/python3 >"$scratch/no_catkin.log"
grep "building without ROS" "$scratch/no_catkin.log"
grep "without ROS: tools ON, Python ON" "$scratch/no_catkin.log"
cmake --build "$scratch/no_catkin" --target help | grep -w segment_depth
