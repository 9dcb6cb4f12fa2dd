# SPDX-License-Identifier: BSD-3-Clause
"""The Python half of the package, for catkin alone: build it with catkin, not with pip."""
from catkin_pkg.python_setup import generate_distutils_setup
from setuptools import setup

setup(**generate_distutils_setup(packages=["line_plane_segmentation"], package_dir={"": "src/python"}))
