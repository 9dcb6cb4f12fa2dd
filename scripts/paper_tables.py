#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of the paper, with its figures and those measured by benchmark_segmentation; called by
scripts/reproduce_paper."""

import argparse
import collections
import csv
import pathlib
import sys

SCENES = ("tabletop", "floor", "corner", "complex")

# Zhang, Chen, Liu 2016 [ms], one thread of an Intel i7 at 2.9 GHz, in the order of SCENES.
PAPER = {
    "lines": (19.0, 38.9, 44.9, 11.6),
    "candidates": (0.64, 0.57, 0.99, 0.13),
    "extraction": (110.0, 112.1, 417.0, 2.3),
    "paper_1": (137.0, 157.4, 469.9, 19.9),
    "paper_1 QVGA": (30.7, 73.7, 174.2, 5.1),
    "paper_3": (237, 315, 1059, 29),
    "paper_5": (365, 471, 1676, 33),
    "ransac": (626.5, 908.6, 891.5, 412.7),
    "rgs": (8282, 10693, 9620, 9301),
    "omps": (88.1, 90.5, 88.2, 72.9),
}

Run = collections.namedtuple("Run", "milliseconds planes")


def three_digits(number):
    """Three significant digits: 12.3, 0.123, 1234."""
    return "%.0f" % number if number >= 100 else "%.3g" % number


def rows_of(path):
    with open(path, newline="") as table:
        return list(csv.DictReader(table))


class Measured:
    """Measurements by scene, method and size."""

    def __init__(self, folder):
        times, stages = rows_of(folder / "times.csv"), rows_of(folder / "stages.csv")
        self.full_width = max(int(row["width"]) for row in times)
        self.frames = list(dict.fromkeys(row["frame"] for row in times))
        self.runs = {(row["frame"], row["method"], int(row["width"])): Run(float(row["median_ms"]), row["planes"])
                     for row in times}
        self.stages = {(row["frame"], row["method"], row["stage"], int(row["width"])): float(row["median_ms"])
                       for row in stages}

    def scenes(self):
        """The scenes of the paper first, then all other frames."""
        return [s for s in SCENES if s in self.frames] + [f for f in self.frames if f not in SCENES]

    def run(self, frame, method, half=False):
        return self.runs.get((frame, method, self.full_width // 2 if half else self.full_width))

    def stage(self, frame, stage):
        return self.stages.get((frame, "paper_1", stage, self.full_width))


def beside(paper_row, scene, milliseconds):
    """'paper / here', '-' for unknown values."""
    paper = PAPER.get(paper_row)
    said = three_digits(paper[SCENES.index(scene)]) if paper and scene in SCENES else "-"
    return "%s / %s" % (said, "-" if milliseconds is None else three_digits(milliseconds))


def table(title, scenes, rows):
    """A Markdown table. rows: pairs of row name and function from scene to cell."""
    lines = ["### " + title, "", "| | " + " | ".join(scenes) + " |", "|---|" + "--:|" * len(scenes)]
    for name, cell in rows:
        lines.append("| %s | %s |" % (name, " | ".join(cell(scene) for scene in scenes)))
    return "\n".join(lines) + "\n"


def method_row(measured, name, method, half=False):
    def cell(scene):
        run = measured.run(scene, method, half)
        return beside(method + (" QVGA" if half else ""), scene, run and run.milliseconds)
    return name, cell


def stage_row(measured, name, stage):
    return name, lambda scene: beside(stage, scene, measured.stage(scene, stage))


def planes_row(measured, name, method):
    def cell(scene):
        run = measured.run(scene, method)
        return run.planes if run else "-"
    return name, cell


def tables(measured):
    scenes = measured.scenes()
    return "\n".join([
        "# The paper's tables, repeated\n",
        "Milliseconds, **paper / here**, medians here, one thread. The paper's machine was an Intel i7 at 2.9 GHz, its "
        "frames are not known: those here are like its pictures. Ratios between methods say more than times.\n",
        table("Table 1: the stages", scenes, [
            stage_row(measured, "line extraction", "lines"),
            stage_row(measured, "candidate detection", "candidates"),
            stage_row(measured, "plane extraction", "extraction"),
            stage_row(measured, "measuring the planes (not in the paper)", "refinement"),
            stage_row(measured, "outlines (not in the paper)", "outlines")]),
        table("Table 2: points of a segment", scenes, [
            method_row(measured, "1 point", "paper_1"),
            method_row(measured, "3 points", "paper_3"),
            method_row(measured, "5 points", "paper_5")]),
        table("Table 3: VGA and QVGA", scenes, [
            method_row(measured, "VGA", "paper_1"),
            method_row(measured, "QVGA", "paper_1", half=True)]),
        table("Table 4: all methods, VGA", scenes, [
            method_row(measured, "the paper's method", "paper_1"),
            method_row(measured, "RANSAC", "ransac"),
            method_row(measured, "RGS", "rgs"),
            method_row(measured, "OMPS", "omps"),
            method_row(measured, "OMPS, refined", "omps_refined"),
            method_row(measured, "this package's default, `adaptive`", "adaptive")]),
        table("Planes found here, VGA", scenes, [
            planes_row(measured, name, name) for name in
            ("paper_1", "paper_3", "paper_5", "ransac", "rgs", "omps", "omps_refined", "adaptive")])])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path, help="results of benchmark_segmentation --out")
    folder = parser.parse_args().folder
    try:
        text = tables(Measured(folder))
    except (OSError, KeyError, ValueError) as error:
        sys.exit("paper_tables: cannot read the measurements in %s: %s" % (folder, error))
    print(text)
    (folder / "paper.md").write_text(text)


if __name__ == "__main__":
    main()
