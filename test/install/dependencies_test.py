#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/install_dependencies states plainly what prevents it from installing, and then runs no apt.

Usage: dependencies_test.py SOURCE
"""
import os
import pathlib
import subprocess
import sys
import tempfile

TOOLS = ("bash", "env", "getent", "mktemp", "rm")
SCRIPTS = {
    "id": "echo 1000",
    "dpkg-query": "exit 1",  # no package is installed
    "apt-get": "touch \"$APT_WAS_RUN\"",
}


def run(source, sudo):
    """Result of install_dependencies for a user who is not root, on a system whose `sudo` is this script, or none."""
    with tempfile.TemporaryDirectory() as folder:
        for name in TOOLS:
            path = next(p for p in ("/usr/bin/" + name, "/bin/" + name) if os.path.exists(p))
            os.symlink(path, os.path.join(folder, name))
        scripts = dict(SCRIPTS, sudo=sudo) if sudo else SCRIPTS
        for name, text in scripts.items():
            script = pathlib.Path(folder, name)
            script.write_text("#!/bin/sh\n" + text + "\n", encoding="utf-8")
            script.chmod(0o755)
        apt_was_run = os.path.join(folder, "apt was run")
        result = subprocess.run(["/bin/bash", os.path.join(source, "scripts", "install_dependencies"), "git"],
                                env={"PATH": folder, "APT_WAS_RUN": apt_was_run}, timeout=60,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)
        return result, os.path.exists(apt_was_run)


def main(source):
    for sudo, expected in (
            ("exit 1", "install_dependencies: sudo was refused; run scripts/install_dependencies once as root\n"),
            (None, "install_dependencies: there is no sudo; run scripts/install_dependencies once as root\n")):
        result, apt_was_run = run(source, sudo)
        assert result.returncode == 1, result
        assert result.stderr == expected, result
        assert " git\n" in result.stdout, result
        assert not apt_was_run, result


if __name__ == "__main__":
    main(*sys.argv[1:])
