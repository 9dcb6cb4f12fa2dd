# SPDX-License-Identifier: BSD-3-Clause
#
# Sourced by the other scripts: the repository's folders, and ROS on the path.
# shellcheck shell=bash

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_directory=$repository/build

# Builds with a sanitizer lie beside the others: use_build_directory_of address|thread|undefined
use_build_directory_of() {
  case $1 in
    address | thread | undefined) build_directory=$repository/build/$1 ;;
    *) echo "There is no sanitizer '$1': address, thread and undefined are known" >&2; exit 1 ;;
  esac
}

# A Python of pyenv or conda in front of the system's has none of ROS's modules.
export PATH=/usr/bin:$PATH
unset PYTHONHOME VIRTUAL_ENV

# The files that ROS has one source refer to variables that need not be set.
source_ros_setup() {
  set +u
  # shellcheck disable=SC1090
  source "$1"
  set -u
}

# On Debian ROS lies in /usr and needs no set-up file.
[ ! -f /opt/ros/noetic/setup.bash ] || source_ros_setup /opt/ros/noetic/setup.bash

# Nodes started by these scripts talk to each other on this machine, whatever its name resolves to, and keep
# their logs in the build folder.
use_local_ros() {
  unset ROS_HOSTNAME
  export ROS_IP=127.0.0.1
  export ROS_HOME=$build_directory/ros_home
  unset ROS_LOG_DIR
}

# A file that includes PCL takes up to 1.5 GB to compile.
jobs_that_fit() {
  local processors gigabytes_and_a_half
  processors=$(nproc)
  gigabytes_and_a_half=$(awk '/^MemAvailable:/ { print int($2 / 1572864) }' /proc/meminfo)
  echo $((gigabytes_and_a_half < 1 ? 1 : gigabytes_and_a_half < processors ? gigabytes_and_a_half : processors))
}

# Says what cmake says only if it fails: configure FOLDER [OPTION OF cmake]...
configure() {
  # catkin keeps the environment of the first configuring for the tests, with only those folders on the paths that
  # are there by then: without this one, Python tests would not find the messages in a fresh clone.
  mkdir -p "$1/devel/lib/python3/dist-packages"
  cmake -S "$repository" -B "$1" -DPYTHON_EXECUTABLE=/usr/bin/python3 "${@:2}" >"$1/configure.log" 2>&1 || {
    cat "$1/configure.log" >&2
    return 1
  }
}

free_port() {
  /usr/bin/python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'
}

# Builds, with these programs of the tests besides, and puts what was built on the path.
build_with_test_programs() {
  "$repository/scripts/build" >&2
  cmake --build "$build_directory" --target "$@" >&2
  source_ros_setup "$build_directory/devel/setup.bash"
}

# From here on there is a master of our own, at $port; one that runs already is not disturbed.
choose_master() {
  port=$(free_port)
  export ROS_MASTER_URI=http://127.0.0.1:$port
}

# Starts roslaunch, as process $master, with a master of its own, and waits for that: start_master LOG [ARGUMENT]...
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

# The same for a launch file beside what a script does: it ends with the script.
launch_beside() {
  use_local_ros
  trap end_master EXIT
  start_master "$build_directory/roslaunch.log" "$@"
}
