# SPDX-License-Identifier: BSD-3-Clause
# Installs the library with what find_package(line_plane_segmentation) needs, where catkin does not.
include(CMakePackageConfigHelpers)

set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/line_plane_segmentation)
install(TARGETS line_plane_segmentation_core EXPORT line_plane_segmentation
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(EXPORT line_plane_segmentation DESTINATION ${config_folder}
  NAMESPACE line_plane_segmentation:: FILE line_plane_segmentationTargets.cmake)
install(DIRECTORY include/line_plane_segmentation/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/line_plane_segmentation)

configure_package_config_file(cmake/line_plane_segmentationConfig.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/line_plane_segmentationConfig.cmake INSTALL_DESTINATION ${config_folder})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/line_plane_segmentationConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/line_plane_segmentationConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/line_plane_segmentationConfigVersion.cmake
  DESTINATION ${config_folder})
