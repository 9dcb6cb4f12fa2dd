#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws from the #include lines which folder uses which other folder or library: the folders of src/ in doc/layout.svg,
those of src/core/ in doc/core_layout.svg. With --check it changes nothing and fails if the .dot files are out of date."""
import argparse
import collections
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PUBLIC = pathlib.Path("line_plane_segmentation")
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)

# First folder or name of an included file -> library. ROS is all that needs a catkin package.
LIBRARIES = {"Eigen": "Eigen", "opencv2": "OpenCV", "pcl": "PCL", "pcl_conversions": "PCL", "boost": "Boost",
             "nlohmann": "nlohmann-json", "openssl": "OpenSSL", "pybind11": "pybind11", "rosbag": "rosbag", "rviz": "rviz"}
ROS = {"ros", "nodelet", "pluginlib", "tf2", "tf2_ros", "tf2_eigen", "image_transport", "message_filters",
       "diagnostic_updater", "dynamic_reconfigure", "sensor_msgs", "geometry_msgs", "shape_msgs", "std_msgs",
       "visualization_msgs", "diagnostic_msgs", "tf2_msgs", "topic_tools", "sensor_msgs", "roscpp", "image_geometry"}


def used_by(text, folder, headers):
    """What a source file of `folder` includes: ("folder", name) or ("library", name)."""
    for include in INCLUDE.findall(text):
        first = include.split("/")[0]
        if first == str(PUBLIC):
            # The public headers are the core's; those of messages and of dynamic_reconfigure are generated.
            yield ("folder", "core") if (ROOT / "include" / include).exists() else ("library", "ROS")
        elif first in LIBRARIES:
            yield "library", LIBRARIES[first]
        elif first in ROS:
            yield "library", "ROS"
        elif "/" not in include and include.endswith(".h"):
            owners = headers.get(include, set())
            if owners and folder not in owners:
                yield "folder", sorted(owners)[0]


def read_layout():
    """{folder: set of what it uses}, for each folder of src/."""
    headers = collections.defaultdict(set)
    for header in (ROOT / "src").rglob("*.h"):
        headers[header.name].add(header.relative_to(ROOT / "src").parts[0])
    layout = collections.defaultdict(set)
    sources = [(path, path.relative_to(ROOT / "src").parts[0]) for path in (ROOT / "src").rglob("*")
               if path.suffix in (".h", ".cpp")]
    sources += [(path, "core") for path in (ROOT / "include").rglob("*.h")]
    for path, folder in sources:
        layout[folder].update(use for use in used_by(path.read_text(encoding="utf-8"), folder, headers)
                              if use != ("folder", folder))
    return layout


def read_core_layout():
    """{folder: set of what it uses}, for each folder of src/core/ and the facade above them. Public headers are left out."""
    core = ROOT / "src" / "core"
    layout = collections.defaultdict(set)
    for path in core.rglob("*"):
        if path.suffix in (".h", ".cpp"):
            parts = path.relative_to(core).parts
            folder = parts[0] if len(parts) > 1 else "PlaneSegmenter"
            for include in INCLUDE.findall(path.read_text(encoding="utf-8")):
                used = include.split("/")[0]
                if "/" in include and used != folder and (core / include).exists():
                    layout[folder].add(("folder", used))
                    layout[used].update()
    return layout


def dot_of(layout, prefix):
    lines = ["// SPDX-License-Identifier: BSD-3-Clause", "// Made by scripts/draw_layout.py from the #include lines.",
             "digraph layout {",
             '  graph [fontname="Helvetica", fontsize=12, ranksep=0.5, nodesep=0.3, bgcolor=white, pad=0.2]',
             '  node [fontname="Helvetica", fontsize=12, shape=box, style="rounded,filled", color="#556677"]',
             '  edge [color="#556677", arrowsize=0.7]']
    for folder in sorted(layout):
        names = sorted(name for kind, name in layout[folder] if kind == "library")
        needs = "\\n" + ", ".join(names) if names else ""
        path = folder if folder == "PlaneSegmenter" else prefix + folder
        lines.append('  %s [label="%s%s", fillcolor="%s"]' %
                     (folder, path, needs, "#eef7ee" if "core" in path else "#eef3fa"))
    for folder in sorted(layout):
        lines += ["  %s -> %s" % (folder, name) for kind, name in sorted(layout[folder]) if kind == "folder"]
    return "\n".join(lines + ["}", ""])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="fail if the .dot files are out of date")
    arguments = parser.parse_args()
    pictures = [("layout", dot_of(read_layout(), "src/"))]
    core = read_core_layout()
    if core:
        pictures.append(("core_layout", dot_of(core, "core/")))
    for name, dot in pictures:
        target = ROOT / "doc" / (name + ".dot")
        if arguments.check:
            if not target.exists() or target.read_text(encoding="utf-8") != dot:
                sys.exit("%s is out of date: run scripts/draw_layout.py" % target)
            continue
        target.write_text(dot, encoding="utf-8")
        subprocess.run(["dot", "-Tsvg", str(target), "-o", str(target.with_suffix(".svg"))], check=True)


if __name__ == "__main__":
    main()
