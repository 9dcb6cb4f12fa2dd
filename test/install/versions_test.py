#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""All files that state the package's version state the same one.

Usage: versions_test.py SOURCE
"""
import pathlib
import re
import sys

PATTERNS = {
    "package.xml": r"<version>([^<]+)</version>",
    "CMakeLists.txt": r"project\(line_plane_segmentation VERSION (\S+)",
    "CITATION.cff": r"(?m)^version: (\S+)$",
}


def main(source):
    versions = {}
    for name, pattern in PATTERNS.items():
        found = re.search(pattern, (pathlib.Path(source) / name).read_text(encoding="utf-8"))
        versions[name] = found.group(1) if found else "no version"
    if len(set(versions.values())) != 1:
        sys.exit("versions differ: %s" % versions)


if __name__ == "__main__":
    main(*sys.argv[1:])
