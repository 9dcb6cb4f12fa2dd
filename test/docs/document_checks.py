#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks of the documents that need no build: every command is listed in commands.txt, launch files and scripts have the
arguments that the commands use, and code examples are those of doc/examples.

    test/docs/document_checks.py
"""
import fractions
import glob
import os
import re
import subprocess
import sys
import unittest
import xml.etree.ElementTree as ElementTree

import documents

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
LANGUAGES = ("sh", "python", "cpp", "cmake", "bibtex", "text", "yaml", "xml")


def read(*path):
    with open(os.path.join(ROOT, *path), encoding="utf-8") as stream:
        return stream.read()


def lines(items):
    return "".join("\n  " + item for item in items)


def constants_of_the_core():
    """((file, name), value) of each constant in src/core; those of the kernels are widths and bit masks."""
    not_of_the_method = {"kPi", "kBlock", "kSeenInByte", "kNoDepthLabel", "kNever", "kFactor",
                         "kMergedScanlines", "kBits"}
    expressions = {"2.4 * BorderSimplifier::kInset": "0.3", "std::size_t{1} << 28": "268435456",
                   "std::numeric_limits<std::uint16_t>::max() - 1": "65534"}
    types = "double|float|int|std::size_t|std::int64_t|std::uint32_t|std::ptrdiff_t|std::uint16_t"
    for path in glob.glob(os.path.join(ROOT, "src", "core", "**", "*.*"), recursive=True):
        if os.sep + "kernels" + os.sep in path or not path.endswith((".h", ".cpp")):
            continue
        code = re.sub(r"//.*", "", read(path))
        for definition in re.findall(r"constexpr (?:%s)\s+(k[^;]+);" % types, code):
            for name, value in re.findall(r"(k\w+)\s*=\s*([^,]+)", definition):
                if name in not_of_the_method:
                    continue
                value = " ".join(value.split())
                number = re.fullmatch(r"(-?[\d.e-]+)F?(?: ([*/]) ([\d.]+))?", expressions.get(value, value))
                if number is None:
                    raise ValueError("%s: %s = %s is no number; list the expression" % (path, name, value))
                value = fractions.Fraction(number[1])
                if number[2]:
                    value = value * int(number[3]) if number[2] == "*" else value / int(float(number[3]))
                yield (os.path.splitext(os.path.basename(path))[0], name), value


class DocumentChecks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.listed = documents.read_list(ROOT)
        cls.commands = documents.commands(ROOT)
        cls.blocks = documents.all_blocks(ROOT)

    def test_the_layout_pictures_are_current(self):
        subprocess.run([sys.executable, os.path.join(ROOT, "scripts", "draw_layout.py"), "--check"], check=True)

    def test_every_block_names_its_language(self):
        for block in self.blocks:
            self.assertIn(block.language, LANGUAGES, "%s:%d" % (block.document, block.line))

    def test_every_command_is_listed(self):
        self.assertGreater(len(self.commands), 30)
        # test/tutorials/tutorials_test.py runs every command of every tutorial.
        unlisted = ["%s: %s" % pair for pair in self.commands
                    if pair[1] not in self.listed and not pair[0].startswith("doc/tutorials/")]
        self.assertFalse(unlisted, "say in test/docs/commands.txt how these are tested:" + lines(unlisted))
        used = {command for _, command in self.commands}
        unused = [command for command in self.listed if command not in used]
        self.assertFalse(unused, "test/docs/commands.txt: no document has these commands:" + lines(unused))

    def test_the_list_names_tests_that_exist(self):
        for command, how in self.listed.items():
            self.assertRegex(how, r"^(run|run \d+|tested by \S+: \S+|not run: .+)$", command)
            match = re.match(r"tested by (\S+): (\S+)", how)
            if match:
                path, word = match.groups()
                self.assertTrue(os.path.exists(os.path.join(ROOT, path)), "%s: there is no %s" % (command, path))
                self.assertIn(word, command)
                self.assertIn(word, read(path), path)

    def test_launch_files_have_the_arguments(self):
        for document, command in self.commands:
            match = re.match(r"roslaunch line_plane_segmentation (\S+\.launch)(.*)", command)
            if match:
                tree = ElementTree.parse(os.path.join(ROOT, "launch", match[1]))
                arguments = {arg.get("name") for arg in tree.getroot().findall("arg") if arg.get("value") is None}
                for name in re.findall(r"(\w+):=", match[2]):
                    self.assertIn(name, arguments, "%s: %s" % (document, command))

    def test_scripts_have_the_options(self):
        scripts = "".join(read(path) for path in glob.glob(os.path.join(ROOT, "scripts", "*")) if os.path.isfile(path))
        for document, command in self.commands:
            if command.startswith("scripts/"):
                self.assertTrue(os.path.exists(os.path.join(ROOT, command.split()[0])), "%s: %s" % (document, command))
                for option in re.findall(r"(?<=\s)--[\w-]+", command):
                    self.assertRegex(scripts, r"%s\b" % option, "%s: %s" % (document, command))

    def test_examples_are_those_of_the_files(self):
        sources = [read(path) for path in glob.glob(os.path.join(ROOT, "doc", "examples", "**"), recursive=True)
                   if path.endswith((".cpp", ".py", ".txt"))]
        blocks = [block for block in self.blocks if block.language in ("cpp", "cmake")]
        self.assertGreaterEqual(len(blocks), 3)
        for block in blocks:
            pattern = r".*?".join(re.escape(line) for line in block.lines if line)
            self.assertTrue(any(re.search(pattern, source, re.DOTALL) for source in sources),
                            "%s:%d: no file of doc/examples has these lines" % (block.document, block.line))

    def test_the_method_lists_the_constants_of_the_core(self):
        listed = {(file, name): fractions.Fraction(value) for file, name, value in
                  re.findall(r"^\| (\w+) \| `(k\w+)` \| (\S+) \|", read("doc", "method.md"), re.MULTILINE)}
        self.assertEqual(dict(constants_of_the_core()), listed)


if __name__ == "__main__":
    unittest.main()
