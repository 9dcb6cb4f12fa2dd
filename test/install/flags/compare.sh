#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds programs with other compiler flags than those of the installed library. Their public types must have the same
# layout; those that this machine can run must print the same, to the last bit.
# Usage: compare.sh SOURCE PREFIX SCRATCH
set -euo pipefail
source_folder=$1
prefix=$2
scratch=$3

if [ "$(uname -m)" != x86_64 ]; then
  echo "Only flags of x86-64 are compared: not tested here."
  exit 0
fi

# Name, compiler flags, and the extensions in /proc/cpuinfo that a machine needs to run the result. The optimisations
# differ since code that is not inlined is shared between program and library.
variants=(
  "sse2:-O1 -march=x86-64:"
  "avx2:-O0 -mavx2:avx2"
  "haswell:-O2 -march=haswell:avx2 fma bmi2"
  "avx512:-O1 -march=skylake-avx512:avx512f avx512bw avx512dq avx512vl"
)

can_run() {
  local extension
  for extension in $1; do grep -qw "$extension" /proc/cpuinfo || return 1; done
}

build() {
  local folder=$1 project=$2 flags=$3
  mkdir -p "$folder"
  if ! {
    cmake -S "$source_folder/$project" -B "$folder" -DCMAKE_DISABLE_FIND_PACKAGE_catkin=ON -DCMAKE_BUILD_TYPE=None \
      -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_FLAGS="$flags" "${@:4}" && cmake --build "$folder"
  } >"$folder/build.log" 2>&1; then
    cat "$folder/build.log" >&2
    return 1
  fi
}

layout=$scratch/layout.h
expected=()
ran=0
for variant in "${variants[@]}"; do
  IFS=: read -r name flags needs <<<"$variant"
  build "$scratch/public_types_$name" test/install/flags "$flags" "${expected[@]}"
  if ! can_run "$needs"; then
    echo "$name: same layout; this machine cannot run it"
    continue
  fi
  "$scratch/public_types_$name/public_types" >"$scratch/$name.results"
  if [ "$name" = sse2 ]; then
    "$scratch/public_types_sse2/public_types" --layout >"$layout"
    expected=(-DEXPECTED_LAYOUT="$layout")
  fi
  cmp "$scratch/sse2.results" "$scratch/$name.results"
  ran=$((ran + 1))
  echo "$name: same layout, same results"
done
[ -s "$layout" ] && [ "$ran" -ge 1 ]

# The example, as users compile it.
build "$scratch/find_planes" doc/examples/library -mavx2
! can_run avx2 || "$scratch/find_planes/find_planes"
