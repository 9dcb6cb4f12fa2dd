# SPDX-License-Identifier: BSD-3-Clause
# For cmake -DCMAKE_TOOLCHAIN_FILE: compiles with Debian's g++-arm-linux-gnueabihf.
set(architecture arm-linux-gnueabihf)
set(processor arm)
set(qemu qemu-arm-static)
include(${CMAKE_CURRENT_LIST_DIR}/debian_cross.cmake)
