# SPDX-License-Identifier: BSD-3-Clause
#
# Sourced by scripts/test before tests that were built with the sanitizer $sanitizer in $build_directory. shellcheck
# shell=bash disable=SC2154

# Each process writes its reports there, including nodes, whose exit codes are not checked.
reports=$build_directory/reports
rm -rf "$reports"
mkdir -p "$reports"
options=log_path=$reports/report
test_options+=(--skip "$repository/test/sanitize/$sanitizer.skip")

case $sanitizer in
  # Python and the nodelet manager load libraries that need the sanitizer's run-time library from the start of the
  # process. Leaks are not checked, since most reports would be about memory that Python and roscpp free at exit; the
  # soak and reload tests check ours. Their bound of memory requires a small quarantine of freed memory.
  address)
    export ASAN_OPTIONS=$options:detect_leaks=0:quarantine_size_mb=4:detect_stack_use_after_return=1:strict_string_checks=1
    # With the sanitizer's library alone, exceptions thrown by a Python module could not be thrown.
    LD_PRELOAD="$("${CXX:-g++}" -print-file-name=libasan.so) $("${CXX:-g++}" -print-file-name=libstdc++.so)"
    export LD_PRELOAD
    ;;
  # Libraries built without the sanitizer may use locks that it does not see.
  thread)
    export TSAN_OPTIONS=$options:ignore_noninstrumented_modules=1:second_deadlock_stack=1
    TSAN_OPTIONS+=:suppressions=$repository/test/sanitize/thread.suppressions
    # Requires the frame rate of a camera, which the segmenter does not reach with the sanitizer.
    export GTEST_FILTER=-SegmentationTest.answersEveryFrameOfACamera
    ;;
  undefined)
    export UBSAN_OPTIONS=$options:print_stacktrace=1
    ;;
esac

# Prints all reports; fails if there are any.
report_findings() {
  local report found=0
  for report in "$reports"/*; do
    [ -s "$report" ] || continue
    found=1
    printf '\n%s\n' "$report"
    cat "$report"
  done
  if [ "$found" -ne 0 ]; then
    echo "test: the sanitizer found what is shown above" >&2
    return 1
  fi
  echo "$sanitizer sanitizer: no reports"
}
