#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs what the documents show: the commands that commands.txt marks "run", and the examples in Python and C++. Runs
beside demo.launch, whose camera and planes the commands use. Arguments: ROOT_OF_THE_REPOSITORY CPP_EXAMPLE"""
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import numpy as np
import rostest
from PIL import Image

import documents

COMMAND_TIMEOUT_SECONDS = 60
ENVIRONMENT = dict(os.environ, PATH="/usr/bin:" + os.environ["PATH"], MPLBACKEND="Agg", PYTHONUNBUFFERED="1")


def run(command, folder, seconds=None):
    """Runs a shell command; after `seconds`, if given, interrupts it. Returns its exit code and output."""
    process = subprocess.Popen(["bash", "-c", command], cwd=folder, env=ENVIRONMENT, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, start_new_session=True, universal_newlines=True)
    try:
        if seconds is not None:
            time.sleep(seconds)
            if process.poll() is not None:
                return process.returncode or 1, "ended by itself:\n" + process.communicate()[0]
            os.killpg(process.pid, signal.SIGINT)
        output = process.communicate(timeout=COMMAND_TIMEOUT_SECONDS)[0]
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        return 1, "did not end:\n" + process.communicate()[0]
    interrupted = seconds is not None and process.returncode in (-signal.SIGINT, 128 + signal.SIGINT)
    return 0 if interrupted else process.returncode, output


class DocumentsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.root, cls.subscriber = (os.path.abspath(path) for path in sys.argv[1:3])
        cls.folder = tempfile.mkdtemp(prefix="documents_test.")

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def expect_floors(self, command):
        """The command prints floors until it is interrupted."""
        code, output = run(command, self.folder, 4)
        self.assertEqual(0, code, output)
        self.assertIn("floor or table", output)

    # Before the commands, which change the parameters of the segmenter.
    def test_1_cpp_subscriber_runs(self):
        self.expect_floors(self.subscriber)

    def test_1_python_examples_run(self):
        blocks = [block for block in documents.all_blocks(self.root) if block.language == "python"]
        self.assertGreaterEqual(len(blocks), 2)
        for block in blocks:
            text = "\n".join(block.lines)
            program = compile(text, "%s:%d" % (block.document, block.line), "exec")
            if "print_floors" in text:
                with open(os.path.join(self.folder, "block.py"), "w", encoding="utf-8") as stream:
                    stream.write(text)
                self.expect_floors("/usr/bin/python3 block.py")
            elif "rospy" not in text:
                names = {"depth": np.full((480, 640), 2000, np.uint16)}
                exec(program, names)
                if "result" in names:
                    self.assertEqual(1, len(names["result"].planes))

    def test_2_commands_run(self):
        # A wall 2 m away, in 5000 units per metre.
        depth = Image.fromarray(np.full((480, 640), 10000, np.uint16))
        depth.save(os.path.join(self.folder, "depth.png"))
        sequence = os.path.join(self.folder, "rgbd_dataset_freiburg1_desk", "depth")
        os.makedirs(sequence)
        depth.save(os.path.join(sequence, "1.png"))
        os.symlink(os.path.join(self.root, "doc"), os.path.join(self.folder, "doc"))
        for command, how in documents.read_list(self.root).items():
            words = how.split()
            if words[0] == "run":
                code, output = run(command, self.folder, float(words[1]) if len(words) > 1 else None)
                self.assertEqual(0, code, "%s\n%s" % (command, output))
        for result in ("planes/depth.planes.json", "planes/1.planes.json", "planes.bag"):
            self.assertTrue(os.path.exists(os.path.join(self.folder, result)), result)

    def test_2_programs_have_the_options(self):
        helps = {}
        for document, command in documents.commands(self.root):
            match = re.match(r"rosrun line_plane_segmentation (\S+)", command)
            for option in re.findall(r"(?<=\s)--[\w-]+", command) if match else []:
                if match[1] not in helps:
                    helps[match[1]] = run(match[0] + " --help", self.folder)[1]
                self.assertRegex(helps[match[1]], r"%s\b" % option, "%s: %s" % (document, command))


if __name__ == "__main__":
    rostest.rosrun("line_plane_segmentation", "documents", DocumentsTest)
