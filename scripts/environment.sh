# SPDX-License-Identifier: BSD-3-Clause
#
# Sourced by the other scripts: the repository's folders, and ROS on the path.
# shellcheck shell=bash

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_directory=$repository/build

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
