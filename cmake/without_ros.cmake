# SPDX-License-Identifier: BSD-3-Clause
# The library, the tools and the Python module for projects without ROS:
#   find_package(line_plane_segmentation REQUIRED)
#   target_link_libraries(... line_plane_segmentation::core)
if(LPS_INSTALL)
  include(GNUInstallDirs)  # which caches its variables: not in a parent project that did not ask for it
endif()
include(cmake/warnings.cmake)
include(cmake/tool_on_path.cmake)

add_subdirectory(src/core)

# AUTO: is all there that a part needs?
if(lps_with_tools STREQUAL AUTO)
  find_package(Boost 1.71 QUIET COMPONENTS program_options)
  find_package(OpenCV 4.2 QUIET COMPONENTS core imgproc imgcodecs)
  find_package(nlohmann_json 3.7 QUIET)
  find_package(OpenSSL QUIET COMPONENTS Crypto)
  set(lps_with_tools OFF)
  if(Boost_FOUND AND OpenCV_FOUND AND nlohmann_json_FOUND AND OpenSSL_FOUND)
    set(lps_with_tools ON)
  endif()
endif()
if(lps_with_python)
  # As src/python looks for it.
  if(PYTHON_EXECUTABLE)
    set(Python3_EXECUTABLE ${PYTHON_EXECUTABLE})
  endif()
  find_package(Python3 QUIET COMPONENTS Interpreter Development)
endif()
if(lps_with_python STREQUAL AUTO)
  find_package(pybind11 2.4 QUIET)
  set(lps_with_python OFF)
  if(Python3_FOUND AND pybind11_FOUND)
    set(lps_with_python ON)
  endif()
endif()
message(STATUS "line_plane_segmentation without ROS: tools ${lps_with_tools}, Python ${lps_with_python}")

# The folders by the names that catkin gives them.
set(CATKIN_PACKAGE_BIN_DESTINATION ${CMAKE_INSTALL_BINDIR})
if(SKBUILD)
  # pip's build collects the module there.
  set(CATKIN_PACKAGE_PYTHON_DESTINATION src/python/line_plane_segmentation)
elseif(lps_with_python AND NOT LPS_PYTHON_DESTINATION)
  # As the interpreter has it, below another prefix: lib/python3/dist-packages, say.
  get_filename_component(folder ${Python3_EXECUTABLE} DIRECTORY)
  file(RELATIVE_PATH folder ${folder}/.. ${Python3_SITEARCH})
  set(CATKIN_PACKAGE_PYTHON_DESTINATION ${folder}/line_plane_segmentation)
elseif(lps_with_python)
  set(CATKIN_PACKAGE_PYTHON_DESTINATION ${LPS_PYTHON_DESTINATION}/line_plane_segmentation)
endif()

if(lps_with_tools)
  add_subdirectory(src/overlay)
  add_subdirectory(src/tools)
endif()
if(lps_with_python)
  add_subdirectory(src/python)
endif()

option(LPS_BUILD_TESTS "The core's tests, which need Google Test" OFF)
if(LPS_BUILD_TESTS)
  enable_testing()
  add_subdirectory(test)
endif()

if(LPS_INSTALL AND NOT SKBUILD)
  include(cmake/install_library.cmake)
endif()
