# SPDX-License-Identifier: BSD-3-Clause
# Which parts are built. AUTO builds a part if all that it needs is installed; ON ends with an error if something is
# missing. Within another project's build (add_subdirectory, FetchContent) AUTO is the library alone.
set(LPS_WITH_ROS AUTO CACHE STRING "Nodelets, messages and bags, which need catkin: AUTO, ON or OFF")
set(LPS_WITH_TOOLS AUTO CACHE STRING "segment_depth and evaluate_segmentation, which need OpenCV, Boost, OpenSSL and nlohmann-json: AUTO, ON or OFF")
set(LPS_WITH_PYTHON AUTO CACHE STRING "The Python module, which needs pybind11: AUTO, ON or OFF")
foreach(option LPS_WITH_ROS LPS_WITH_TOOLS LPS_WITH_PYTHON)
  set_property(CACHE ${option} PROPERTY STRINGS AUTO ON OFF)
endforeach()
option(LPS_MESSAGES_ONLY "The messages alone, for computers that only receive planes: needs no PCL" OFF)
option(LPS_INSTALL "Installs what is built without ROS" ${LPS_IS_TOP_LEVEL})
option(LPS_WARNINGS_AS_ERRORS "Warnings end the build, as in CI" OFF)

# Variables of this project's folders, which the cached options are not changed by: lps_with_ros, ...
set(lps_with_ros ${LPS_WITH_ROS})
set(lps_with_tools ${LPS_WITH_TOOLS})
set(lps_with_python ${LPS_WITH_PYTHON})
if(NOT LPS_IS_TOP_LEVEL)
  foreach(part lps_with_ros lps_with_tools lps_with_python)
    if(${part} STREQUAL AUTO)
      set(${part} OFF)
    endif()
  endforeach()
endif()

if(LPS_MESSAGES_ONLY)
  set(lps_with_ros ON)
elseif(lps_with_ros STREQUAL AUTO)
  #catkin_lint: ignore_once missing_required
  find_package(catkin QUIET)
  set(lps_with_ros ${catkin_FOUND})
  if(NOT catkin_FOUND)
    message(STATUS "catkin is not installed, or its setup file not sourced: building without ROS")
  endif()
endif()
