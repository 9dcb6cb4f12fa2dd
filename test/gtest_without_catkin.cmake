# SPDX-License-Identifier: BSD-3-Clause
# Google Test for builds without catkin, from its sources where Debian's packages put them: so it is compiled for the
# machine that is built for.
if(EXISTS /usr/src/googletest/CMakeLists.txt)
  set(BUILD_GMOCK OFF CACHE BOOL "not needed")
  set(INSTALL_GTEST OFF CACHE BOOL "not needed")
  add_subdirectory(/usr/src/googletest ${CMAKE_BINARY_DIR}/googletest EXCLUDE_FROM_ALL)
else()
  find_package(GTest REQUIRED)
endif()

# As catkin's function of this name. The target core_tests builds them all.
add_custom_target(core_tests)
function(catkin_add_gtest name)
  add_executable(${name} EXCLUDE_FROM_ALL ${ARGN})
  target_link_libraries(${name} GTest::gtest)
  add_dependencies(core_tests ${name})
  add_test(NAME ${name} COMMAND ${name})
endfunction()
