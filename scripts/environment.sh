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

free_port() {
  /usr/bin/python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'
}

# Builds, with one program of the tests besides, and puts what was built on the path.
build_with_test_program() {
  "$repository/scripts/build" >&2
  cmake --build "$build_directory" --target "$1" >&2
  source_ros_setup "$build_directory/devel/setup.bash"
}

# Starts a launch file with a master of its own, which ends with the script; one that runs already is not disturbed.
launch_beside() {
  use_local_ros
  local port
  port=$(free_port)
  export ROS_MASTER_URI=http://127.0.0.1:$port
  roslaunch --port="$port" "$@" >"$build_directory/roslaunch.log" 2>&1 &
  launch=$!
  trap 'kill -TERM "$launch" 2>/dev/null; wait "$launch" 2>/dev/null || true' EXIT
  for _ in {1..100}; do
    rosparam get /run_id >/dev/null 2>&1 && return
    sleep 0.2
  done
  cat "$build_directory/roslaunch.log" >&2
  return 1
}
