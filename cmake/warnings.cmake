# SPDX-License-Identifier: BSD-3-Clause
# The package's own targets are compiled with this; the flags of other packages stay theirs.
add_library(lps_warnings INTERFACE)
if(MSVC)
  target_compile_options(lps_warnings INTERFACE /W4 $<$<BOOL:${LPS_WARNINGS_AS_ERRORS}>:/WX>)
else()
  target_compile_options(lps_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wcast-align
    $<$<BOOL:${LPS_WARNINGS_AS_ERRORS}>:-Werror>)
endif()
