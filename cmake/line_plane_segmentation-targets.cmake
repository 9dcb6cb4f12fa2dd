# SPDX-License-Identifier: BSD-3-Clause
# Included by what catkin generates: the same target that the library has where it is built without ROS.
if(NOT TARGET line_plane_segmentation::core)
  find_package(Eigen3 3.3 REQUIRED NO_MODULE)
  # The libraries of the packages that the messages need are among them, too.
  set(line_plane_segmentation_core_libraries ${line_plane_segmentation_LIBRARIES})
  list(FILTER line_plane_segmentation_core_libraries INCLUDE REGEX line_plane_segmentation_core)
  add_library(line_plane_segmentation::core INTERFACE IMPORTED)
  set_target_properties(line_plane_segmentation::core PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${line_plane_segmentation_INCLUDE_DIRS}"
    INTERFACE_COMPILE_FEATURES cxx_std_17
    INTERFACE_LINK_LIBRARIES "${line_plane_segmentation_core_libraries};Eigen3::Eigen")
endif()
