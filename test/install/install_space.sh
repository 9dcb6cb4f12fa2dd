#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs the package, and uses it from there as a user would, with the build folder out of sight.
# Usage: install_space.sh SOURCE BUILD PREFIX SCRATCH
set -euo pipefail
source_folder=$1
build=$2
prefix=$3
scratch=$4

rm -rf "$prefix" "$scratch"
mkdir -p "$scratch"
# What stays in the build folder lies within the package, where roslaunch would find two of each launch file.
trap 'rm -rf "$prefix"' EXIT
# An environment that knows nothing of the build's devel space. On Ubuntu the installed set-up file brings ROS's.
clean=(env -i HOME="$HOME" PATH=/usr/bin:/bin ROS_HOME="$scratch/ros_home")
"${clean[@]}" cmake --install "$build" >"$scratch/install.log" ||
  { tail -n 20 "$scratch/install.log"; exit 1; }

"${clean[@]}" bash -s "$source_folder" "$prefix" "$scratch" <<'END'
set -eo pipefail
source "$2/setup.bash"
case $(rospack find line_plane_segmentation) in "$2"/*) ;; *) echo "found elsewhere"; exit 1 ;; esac

for tool in segment_depth segment_bag evaluate_segmentation benchmark_segmentation benchmark_messages; do
  echo "$tool"
  rosrun line_plane_segmentation "$tool" --help >/dev/null
  # On the PATH of the sourced workspace, too.
  [ "$(command -v "$tool")" = "$2/bin/$tool" ]
  "$tool" --version | grep -qx "$tool [0-9]*\.[0-9]*\.[0-9]*"
done
# Reading openni2.launch ends with an error where the camera's driver is not installed.
for launch_file in "$1"/launch/*.launch; do
  name=$(basename "$launch_file")
  echo "$name"
  arguments=()
  [ "$name" != playback.launch ] || arguments=(bag:=x.bag)
  [ "$name" = openni2.launch ] || roslaunch --files line_plane_segmentation "$name" "${arguments[@]}" >/dev/null
done
python3 -c "
from line_plane_segmentation import PlaneSegmenter
from line_plane_segmentation.msg import PlaneArray
from line_plane_segmentation.cfg import PlaneSegmenterConfig"
if ldd "$2"/lib/*.so "$2"/lib/line_plane_segmentation/* 2>/dev/null | grep "not found"; then exit 1; fi

cmake -S "$1/doc/examples/library" -B "$3/example" -DPYTHON_EXECUTABLE=/usr/bin/python3
cmake --build "$3/example"
"$3/example/find_planes"
END
