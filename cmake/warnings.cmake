# SPDX-License-Identifier: BSD-3-Clause
# The package's own targets are compiled with this; the flags of other packages stay theirs.
add_library(lps_warnings INTERFACE)
if(MSVC)
  target_compile_options(lps_warnings INTERFACE /W4 $<$<BOOL:${LPS_WARNINGS_AS_ERRORS}>:/WX>)
else()
  target_compile_options(lps_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wcast-align
    # Clang's -Wconversion includes this warning, GCC's does not: signed subscripts of vectors are allowed.
    $<$<OR:$<CXX_COMPILER_ID:Clang>,$<CXX_COMPILER_ID:AppleClang>>:-Wno-sign-conversion>
    $<$<BOOL:${LPS_WARNINGS_AS_ERRORS}>:-Werror>)
endif()
