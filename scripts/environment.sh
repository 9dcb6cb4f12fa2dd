# SPDX-License-Identifier: BSD-3-Clause
#
# Sourced by the other scripts: the repository's folders, and ROS on the path.
# shellcheck shell=bash

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_directory=$repository/build

# Builds with a sanitizer have a folder of their own: use_build_directory_of address|thread|undefined
use_build_directory_of() {
  case $1 in
    address | thread | undefined) build_directory=$repository/build/$1 ;;
    *) echo "There is no sanitizer '$1': address, thread and undefined are known" >&2; exit 1 ;;
  esac
}

# A Python of pyenv or conda, first on the path, does not have ROS's modules.
export PATH=/usr/bin:$PATH
unset PYTHONHOME VIRTUAL_ENV

# ROS's setup files use variables that may be unset.
source_ros_setup() {
  set +u
  # shellcheck disable=SC1090
  source "$1"
  set -u
}

# On Debian, ROS is in /usr and needs no setup file.
[ ! -f /opt/ros/noetic/setup.bash ] || source_ros_setup /opt/ros/noetic/setup.bash

# Nodes started by these scripts communicate over the loopback interface, independent of name resolution, and write
# their logs to the build folder.
use_local_ros() {
  unset ROS_HOSTNAME
  export ROS_IP=127.0.0.1
  export ROS_HOME=$build_directory/ros_home
  unset ROS_LOG_DIR
}

# Compiling a file that includes PCL needs up to 1.5 GB.
jobs_that_fit() {
  local processors gigabytes_and_a_half
  processors=$(nproc)
  gigabytes_and_a_half=$(awk '/^MemAvailable:/ { print int($2 / 1572864) }' /proc/meminfo)
  echo $((gigabytes_and_a_half < 1 ? 1 : gigabytes_and_a_half < processors ? gigabytes_and_a_half : processors))
}

# The last processor that this process may run on. nproc does not tell: it counts, and obeys OMP_NUM_THREADS.
last_processor() { sed -n 's/^Cpus_allowed_list:.*[^0-9]\([0-9]*\)$/\1/p' /proc/self/status; }

# Prints cmake's output only if it fails: configure FOLDER [OPTION OF cmake]...
configure() {
  # catkin stores the environment of the first configuration for the tests, with only the folders that exist then.
  # Without this folder, Python tests in a fresh clone would not find the messages.
  mkdir -p "$1/devel/lib/python3/dist-packages"
  cmake -S "$repository" -B "$1" -DPYTHON_EXECUTABLE=/usr/bin/python3 -DCMAKE_EXPORT_COMPILE_COMMANDS=ON "${@:2}" >"$1/configure.log" 2>&1 || {
    cat "$1/configure.log" >&2
    return 1
  }
}

free_port() {
  /usr/bin/python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'
}

# Builds the package and the given test programs, and sources the result.
build_with_test_programs() {
  "$repository/scripts/build" >&2
  cmake --build "$build_directory" --target "$@" >&2
  source_ros_setup "$build_directory/devel/setup.bash"
}

# Selects a free port for a separate master, $port, so that a running one is not disturbed.
choose_master() {
  port=$(free_port)
  export ROS_MASTER_URI=http://127.0.0.1:$port
}

# Starts roslaunch with a separate master as process $master, and waits for the master: start_master LOG [ARGUMENT]...
start_master() {
  local log=$1
  choose_master
  roslaunch --port="$port" "${@:2}" >"$log" 2>&1 &
  master=$!
  for _ in {1..100}; do
    rosparam get /run_id >/dev/null 2>&1 && return
    kill -0 "$master" 2>/dev/null || break
    sleep 0.2
  done
  echo "roslaunch ${*:2}: no master came up; $log ends with:" >&2
  tail -n 30 "$log" >&2
  return 1
}

end_master() {
  [ -n "${master:-}" ] || return 0
  kill -TERM "$master" 2>/dev/null || true
  wait "$master" 2>/dev/null || true
}

# Like start_master, for a launch file that ends with the script.
launch_beside() {
  use_local_ros
  trap end_master EXIT
  start_master "$build_directory/roslaunch.log" "$@"
}

# Runs a Python script of scripts/ on one image of the simulated camera: show_simulated_image SCRIPT OUT
show_simulated_image() {
  "$repository/scripts/build"
  source_ros_setup "$build_directory/devel/setup.bash"
  use_local_ros
  work=$(mktemp -d)
  camera=
  trap 'kill "$camera" 2>/dev/null || true; end_master; rm -rf "$work"' EXIT
  start_master "$work/roslaunch.log" --core
  rosrun nodelet nodelet standalone line_plane_segmentation/simulated_camera _seed:=3 _rate:=2 >"$work/camera.log" 2>&1 &
  camera=$!
  /usr/bin/python3 "$repository/scripts/$1" --topic depth/image_raw --out "$2"
}
