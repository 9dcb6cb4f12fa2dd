#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs the Python module with pip from a copy of the sources, and uses it where there is no ROS. Needs no network:
# pip's build takes what the distribution has.
# Usage: python_wheel.sh SOURCE SCRATCH
set -euo pipefail
source_folder=$1
scratch=$2

rm -rf "$scratch"
mkdir -p "$scratch/source" "$scratch/home"
(cd "$source_folder" && cp -r CMakeLists.txt LICENSE README.md cfg cmake include package.xml pyproject.toml setup.py src \
  "$scratch/source")

clean=(env -i HOME="$scratch/home" PATH=/usr/bin:/bin MPLBACKEND=Agg)
for variable in CC CXX CMAKE_CXX_COMPILER_LAUNCHER "${!CCACHE_@}"; do
  [ -z "${!variable:-}" ] || clean+=("$variable=${!variable}")
done
# Not optimised: results do not depend on it, and this is built for a test alone.
"${clean[@]}" SKBUILD_CONFIGURE_OPTIONS="-DCMAKE_CXX_FLAGS_RELEASE=-O0 -DLPS_FAST_BUILD=ON" CMAKE_BUILD_PARALLEL_LEVEL=2 \
  python3 -m pip install --no-build-isolation --no-deps --no-index --target "$scratch/site" "$scratch/source"

"${clean[@]}" PYTHONPATH="$scratch/site" python3 "$source_folder/test/install/python_wheel_test.py" \
  "$scratch/site" "$source_folder"
