# SPDX-License-Identifier: BSD-3-Clause
# Shortens builds of everything at once, as in CI. Off by default: a change of one file compiles more than that file,
# and a source that lacks an #include may still compile.
option(LPS_FAST_BUILD "Compiles sources in groups, and headers that many of them include once" OFF)

# Compiles the sources of a target in groups. Sources that define what another one of the target defines, too, such as a
# function of the same name in an unnamed namespace, follow the target's name: they are compiled alone.
function(lps_join_sources target)
  if(LPS_FAST_BUILD)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
    if(ARGN)
      set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
  endif()
endfunction()

# Compiles headers once for a target.
function(lps_precompile target)
  if(LPS_FAST_BUILD)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()

# Compiles headers once for all tests of a folder, whose options must be the same.
function(lps_precompile_for_tests target)
  if(NOT LPS_FAST_BUILD OR NOT TARGET ${target})
    return()
  endif()
  get_property(first DIRECTORY PROPERTY LPS_PRECOMPILED_TEST)
  if(first)
    target_precompile_headers(${target} REUSE_FROM ${first})
  else()
    target_precompile_headers(${target} PRIVATE ${ARGN})
    set_property(DIRECTORY PROPERTY LPS_PRECOMPILED_TEST ${target})
  endif()
endfunction()
