# SPDX-License-Identifier: BSD-3-Clause
"""Reads the documents: their commands, their code examples, and the list of how each command is tested."""
import collections
import glob
import os
import re

Block = collections.namedtuple("Block", "document line language lines")

# A command in running text: a program of ROS or of this repository with at least one argument.
INLINE_COMMAND = re.compile(r"`((?:rosrun|roslaunch|rostopic|rosmsg|rosbag|rossrv|cmake|doxygen|scripts/\w+) [^`]+)`")


def documents(root):
    """README.md, CONTRIBUTING.md and all Markdown files below doc/, relative to `root`."""
    paths = [os.path.join(root, name) for name in ("README.md", "CONTRIBUTING.md")]
    paths += sorted(glob.glob(os.path.join(root, "doc", "**", "*.md"), recursive=True))
    return [os.path.relpath(path, root) for path in paths]


def read_blocks(root, document):
    """The fenced blocks of a document."""
    blocks, language, lines, first = [], None, [], 0
    with open(os.path.join(root, document), encoding="utf-8") as stream:
        for number, line in enumerate(stream, 1):
            line = line.rstrip("\n")
            if line.lstrip().startswith("```"):
                if language is None:
                    language, lines, first = line.lstrip()[3:].strip(), [], number
                else:
                    blocks.append(Block(document, first, language, lines))
                    language = None
            elif language is not None:
                lines.append(line)
    if language is not None:
        raise ValueError("%s:%d: the block is not closed" % (document, first))
    return blocks


def normalized(command):
    """The command without a trailing comment, with single spaces."""
    return " ".join(re.sub(r"\s+#.*", "", command).split())


def commands_of_block(block):
    joined = "\n".join(block.lines).replace("\\\n", " ")
    return [command for command in map(normalized, joined.split("\n")) if command and not command.startswith("#")]


def inline_commands(root, document):
    """The commands in the text between the fenced blocks."""
    with open(os.path.join(root, document), encoding="utf-8") as stream:
        text = re.sub(r"^\s*```.*?^\s*```", "", stream.read(), flags=re.DOTALL | re.MULTILINE)
    return [normalized(match) for match in INLINE_COMMAND.findall(" ".join(text.split("\n")))]


def commands(root):
    """(document, command) of all documents, in order."""
    found = []
    for document in documents(root):
        for block in read_blocks(root, document):
            if block.language == "sh":
                found += [(document, command) for command in commands_of_block(block)]
        found += [(document, command) for command in inline_commands(root, document)]
    return found


def all_blocks(root):
    return [block for document in documents(root) for block in read_blocks(root, document)]


def read_list(root):
    """{command: how it is tested} from commands.txt, in its order."""
    path = os.path.join(root, "test", "docs", "commands.txt")
    entries, command = collections.OrderedDict(), None
    with open(path, encoding="utf-8") as stream:
        for number, line in enumerate(stream, 1):
            if line.startswith("#") or not line.strip():
                continue
            if line.startswith(" "):
                if command is None:
                    raise ValueError("%s:%d: no command above" % (path, number))
                entries[command] = line.strip()
                command = None
            else:
                command = line.strip()
                if command in entries:
                    raise ValueError("%s:%d: listed twice: %s" % (path, number, command))
    return entries
