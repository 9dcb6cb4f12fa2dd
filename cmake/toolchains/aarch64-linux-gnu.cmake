# SPDX-License-Identifier: BSD-3-Clause
# For cmake -DCMAKE_TOOLCHAIN_FILE: compiles with Debian's g++-aarch64-linux-gnu.
set(architecture aarch64-linux-gnu)
set(processor aarch64)
set(qemu qemu-aarch64-static)
include(${CMAKE_CURRENT_LIST_DIR}/debian_cross.cmake)
