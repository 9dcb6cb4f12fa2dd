#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Looks for NEON instructions in the hot loops of the core: in each function that LPS_MULTIVERSION stands before, which
on x86-64 is compiled for several vector widths. If the compiler has inlined it, or it leaves the loop to a function of
its file, the instructions may be there.

Usage: check_vectorized.py SOURCE_FOLDER LIBRARY.a
"""
import pathlib
import re
import subprocess
import sys

# An instruction on lanes, such as `fmla v0.4s, v1.4s, v2.4s`; scalar code uses movi, to clear registers.
VECTOR_INSTRUCTION = re.compile(r"^(?!movi|mvni|fmov)\w+\s.*\bv\d+\.(2d|4s|8h|16b)")

# From the name of a function to the brace in the first column that ends it.
FUNCTION = re.compile(r"(?m)^(?:[\w:<>,&*~ ]*?[ *&])??([\w:]+)\([^;{}]*\)[^;{}]*\{(.*(?:\n(?!\}).*)*)")


def hot_functions(source):
    """Each hot function of a file with those that its loops may be found in instead: that it calls, or that call it."""
    bodies = {name.split("::")[-1]: body for name, body in FUNCTION.findall(source)}
    for name in re.findall(r"LPS_MULTIVERSION\b[^;{(]*?\b(\w+)\s*\(", source):
        called = set(re.findall(r"\b(\w+)(?:<[\w, ]+>)?\(", bodies.get(name, "")))
        callers = {other for other, body in bodies.items() if re.search(r"\b%s\(" % name, body)}
        yield name, (called & set(bodies)) | callers


def vector_instructions(library):
    """How many vector instructions each function of the library has, by its name without namespace and arguments."""
    listing = subprocess.run(["aarch64-linux-gnu-objdump", "-d", "-C", "--no-show-raw-insn", library],
                             stdout=subprocess.PIPE, check=True).stdout.decode()
    counts, name = {}, None
    for line in listing.splitlines():
        start = re.match(r"^[0-9a-f]+ <(.*)>:$", line)
        if start:
            plain = start.group(1).replace("(anonymous namespace)::", "")
            name = re.split(r"[(<]", plain)[0].split("::")[-1].split(" ")[-1]
            counts.setdefault(name, 0)
        elif name and VECTOR_INSTRUCTION.match(line.split(":", 1)[-1].strip()):
            counts[name] += 1
    return counts


def main(folder, library):
    counts = vector_instructions(library)
    hot = missing = 0
    for source in sorted(pathlib.Path(folder).rglob("*.cpp")):
        for name, relatives in hot_functions(source.read_text(encoding="utf-8")):
            hot += 1
            places = [place for place in [name] + sorted(relatives) if counts.get(place)]
            missing += not places
            print("%-20s %s" % (name, ", ".join("%d in %s" % (counts[p], p) for p in places) or "no vector instructions"))
    if hot == 0 or missing:
        sys.exit("check_vectorized: %d of %d hot loops have no NEON instructions" % (missing, hot))


if __name__ == "__main__":
    main(*sys.argv[1:])
