# SPDX-License-Identifier: BSD-3-Clause
# Compiles with a cross compiler of Debian, and runs tests with its qemu-user-static. Included with
#   architecture  Debian's triplet, the prefix of the compiler
#   processor     CMAKE_SYSTEM_PROCESSOR
#   qemu          the emulator
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR ${processor})
set(CMAKE_C_COMPILER ${architecture}-gcc)
set(CMAKE_CXX_COMPILER ${architecture}-g++)
set(CMAKE_CROSSCOMPILING_EMULATOR ${qemu};-L;/usr/${architecture})
if(CMAKE_SYSROOT)
  # The root folder of such a system, with all that the tools and the Python module need: scripts/test_arm_tools.
  set(CMAKE_LIBRARY_ARCHITECTURE ${architecture})
  set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
  set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
else()
  # Headers without architecture, as Eigen's, are taken from this machine, libraries are not.
  set(CMAKE_FIND_ROOT_PATH /usr/${architecture})
endif()
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
