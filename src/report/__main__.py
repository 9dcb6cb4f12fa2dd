# SPDX-License-Identifier: BSD-3-Clause
"""Makes pages, plots and tables of what the command-line tools measured.

    python3 report KIND <DATA.json >FILE

KIND is one of
    html         page of segment_depth: overlays, planes and times of each frame
    curve        PNG of evaluate_segmentation: classification of the regions over the tolerance
    markdown     benchmark.md of benchmark_segmentation
    times        PNG of benchmark_segmentation: the methods' times
    times_csv, stages_csv   tables of benchmark_segmentation
    messages     messages.md of benchmark_messages
    sheet        PNG: pictures in rows and columns
The tools start it; their --json files and those in their output folders suit it as well.
"""

import json
import sys


def make(kind, data):
    """The content of the file, as bytes."""
    # Imported where needed: matplotlib takes half a second.
    if kind == "html":
        import page
        return page.html(data)
    if kind in ("markdown", "times_csv", "stages_csv", "messages"):
        import tables
        return getattr(tables, kind)(data).encode()
    if kind in ("curve", "times"):
        import plots
        return getattr(plots, kind)(data)
    if kind == "sheet":
        import sheet
        return sheet.sheet(data)
    raise SystemExit("there is no kind of report named '%s'" % kind)


def main():
    if len(sys.argv) != 2 or sys.argv[1] in ("-h", "--help"):
        print(__doc__)
        return
    sys.stdout.buffer.write(make(sys.argv[1], json.load(sys.stdin)))


if __name__ == "__main__":
    main()
