#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Looks for NEON arithmetic in the hot loops of the core: in each function that LPS_MULTIVERSION stands before, which on
x86-64 is compiled for several vector widths.

Usage: check_vectorized.py SOURCE_FOLDER LIBRARY.a
"""
import pathlib
import re
import subprocess
import sys

# An instruction on lanes, such as `fmla v0.4s, v1.4s, v2.4s`, and no mere copy or load.
VECTOR_ARITHMETIC = re.compile(r"^(f|s|u|cm|add|sub|mul|mla|mls|and|orr|eor|bic|bsl|bif|bit)\w*\s+v\d+\.(2d|4s|8h|16b)")


def hot_functions(folder):
    names = set()
    for source in pathlib.Path(folder).glob("*.cpp"):
        text = source.read_text(encoding="utf-8")
        names.update(re.findall(r"LPS_MULTIVERSION\b[^;{(]*?\b(\w+)\s*\(", text))
    return names


def vector_instructions(library):
    """How many vector instructions each function of the library has, by its name without namespace and arguments."""
    listing = subprocess.run(["aarch64-linux-gnu-objdump", "-d", "-C", "--no-show-raw-insn", library],
                             stdout=subprocess.PIPE, check=True).stdout.decode()
    counts, name = {}, None
    for line in listing.splitlines():
        start = re.match(r"^[0-9a-f]+ <(.*)>:$", line)
        if start:
            plain = re.sub(r"\(anonymous namespace\)::", "", start.group(1))
            name = re.split(r"[(<]", plain)[0].split("::")[-1].split(" ")[-1]
            counts.setdefault(name, 0)
        elif name and VECTOR_ARITHMETIC.match(line.split(":", 1)[-1].strip()):
            counts[name] += 1
    return counts


def main(folder, library):
    hot = hot_functions(folder)
    counts = vector_instructions(library)
    if not hot:
        sys.exit("check_vectorized: no function in %s is marked LPS_MULTIVERSION" % folder)
    missing = [name for name in sorted(hot) if not counts.get(name)]
    for name in sorted(hot):
        print("%-32s %4s vector instructions" % (name, counts.get(name, "no")))
    if missing:
        sys.exit("check_vectorized: without NEON: " + ", ".join(missing))


if __name__ == "__main__":
    main(*sys.argv[1:])
