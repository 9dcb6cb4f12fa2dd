# SPDX-License-Identifier: BSD-3-Clause
#
# Sourced by scripts/test, before tests that were built with the sanitizer $sanitizer in $build_directory.
# shellcheck shell=bash disable=SC2154

# Each process writes its reports there, also nodes, whose exit codes nobody looks at.
reports=$build_directory/reports
rm -rf "$reports"
mkdir -p "$reports"
options=log_path=$reports/report
test_options+=(--skip "$repository/test/sanitize/$sanitizer.skip")

case $sanitizer in
  # Python and the nodelet manager know nothing of the sanitizer that what they load needs from their start on. What
  # they and roscpp leave to the process's end would be most of the leaks; for ours there are the soak and reload tests,
  # whose bound of memory leaves little room for what is kept to notice its use after it was freed.
  address)
    export ASAN_OPTIONS=$options:detect_leaks=0:quarantine_size_mb=4:detect_stack_use_after_return=1:strict_string_checks=1
    # With the sanitizer alone, Python's process would not find how to throw what a module throws.
    LD_PRELOAD="$("${CXX:-g++}" -print-file-name=libasan.so) $("${CXX:-g++}" -print-file-name=libstdc++.so)"
    export LD_PRELOAD
    ;;
  # A library that was not built so may lock in ways that the sanitizer does not see.
  thread)
    export TSAN_OPTIONS=$options:ignore_noninstrumented_modules=1:second_deadlock_stack=1
    TSAN_OPTIONS+=:suppressions=$repository/test/sanitize/thread.suppressions
    # Asks for a camera's speed, which the segmenter does not have so.
    export GTEST_FILTER=-SegmentationTest.answersEveryFrameOfACamera
    ;;
  undefined)
    export UBSAN_OPTIONS=$options:print_stacktrace=1
    ;;
esac

# Shows all reports; fails if there are any.
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
