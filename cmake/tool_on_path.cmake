# SPDX-License-Identifier: BSD-3-Clause

# Builds a command-line tool where rosrun looks for it, and puts it on the PATH of workspaces whose setup file is
# sourced. Installing the tool itself is left to the caller.
function(lps_put_tool_on_path tool)
  if(NOT lps_with_ros)
    return()
  endif()
  set_target_properties(${tool} PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY ${CATKIN_DEVEL_PREFIX}/${CATKIN_PACKAGE_BIN_DESTINATION})
  file(RELATIVE_PATH relative /${CATKIN_GLOBAL_BIN_DESTINATION} /${CATKIN_PACKAGE_BIN_DESTINATION}/${tool})
  set(folder ${CATKIN_DEVEL_PREFIX}/${CATKIN_GLOBAL_BIN_DESTINATION})
  file(MAKE_DIRECTORY ${folder})
  # Not before the tool is there: a build of other targets, as for fuzzing, would leave a link to nothing, on which
  # rosrun's search ends.
  add_custom_command(TARGET ${tool} POST_BUILD COMMAND ${CMAKE_COMMAND} -E create_symlink ${relative} ${folder}/${tool})
  install(FILES ${folder}/${tool} DESTINATION ${CATKIN_GLOBAL_BIN_DESTINATION})
endfunction()
