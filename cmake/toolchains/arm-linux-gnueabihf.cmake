# SPDX-License-Identifier: BSD-3-Clause
# For cmake -DCMAKE_TOOLCHAIN_FILE: compiles with Debian's g++-arm-linux-gnueabihf, and runs tests with its qemu-user-static.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_C_COMPILER arm-linux-gnueabihf-gcc)
set(CMAKE_CXX_COMPILER arm-linux-gnueabihf-g++)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-arm-static;-L;/usr/arm-linux-gnueabihf)
if(CMAKE_SYSROOT)
  # The root folder of such a system, with all that the tools and the Python module need: scripts/test_arm_tools.
  set(CMAKE_LIBRARY_ARCHITECTURE arm-linux-gnueabihf)
  set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
  set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
else()
  # Headers without architecture, as Eigen's, are taken from this machine, libraries are not.
  set(CMAKE_FIND_ROOT_PATH /usr/arm-linux-gnueabihf)
endif()
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
