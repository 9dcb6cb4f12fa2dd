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
