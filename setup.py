# SPDX-License-Identifier: BSD-3-Clause
"""The Python half of the package: for catkin, which reads package.xml, and for pip, which builds a wheel without ROS."""
import os
import sys
import xml.etree.ElementTree as ElementTree

PACKAGES = dict(packages=["line_plane_segmentation"], package_dir={"": "src/python"})


def setup_with_catkin():
    from catkin_pkg.python_setup import generate_distutils_setup
    from setuptools import setup

    setup(**generate_distutils_setup(**PACKAGES))


def setup_with_pip():
    """scikit-build has CMake compile the module; the version and the texts are those of package.xml."""
    from skbuild import setup

    package = ElementTree.parse(os.path.join(os.path.dirname(os.path.abspath(__file__)), "package.xml")).getroot()

    def text(tag):
        return " ".join(package.find(tag).text.split())

    setup(
        name=text("name"),
        version=text("version"),
        description=text("description"),
        license=text("license"),
        url=text("url"),
        maintainer=text("maintainer"),
        maintainer_email=package.find("maintainer").get("email"),
        python_requires=">=3.8",
        install_requires=["numpy"],
        package_data={"line_plane_segmentation": ["*.pyi", "py.typed"]},
        cmake_args=["-DLPS_WITH_ROS=OFF", "-DLPS_WITH_TOOLS=OFF", "-DLPS_WITH_PYTHON=ON",
                    "-DBUILD_SHARED_LIBS=OFF"],
        **PACKAGES)


if "setuptools.build_meta" in sys.modules:
    setup_with_pip()
else:
    setup_with_catkin()
