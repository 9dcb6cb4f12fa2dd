# SPDX-License-Identifier: BSD-3-Clause
"""Tables of the benchmarks as Markdown and CSV.

A measurement is a dictionary: frame, width, height, method, planes; total, cold and warm, cold_wall and warm_wall, which
are statistics [ms]; and stages, statistics by the name of the stage. A statistic has median, min, max, p90, p99 and runs.
"""

import csv
import io
import math
import statistics


def three_digits(number):
    """A time or a ratio with three significant digits, but at most three decimals."""
    digits_before = math.floor(math.log10(number)) + 1 if number >= 1 else 0
    return "%.*f" % (max(0, 3 - digits_before), number)


def size_of(m):
    return "%dx%d" % (m["width"], m["height"])


def frame_of(m):
    return "%s, %s" % (m["frame"], size_of(m))


def find(measurements, on_frame_of, method):
    """The measurement of a method on the same frame and size, None if there is none."""
    return next((m for m in measurements if m["method"] == method and frame_of(m) == frame_of(on_frame_of)), None)


def ratio_to(reference, measurements, m):
    """The reference's median over the measurement's on the same frame; 0 if the reference was left out."""
    other = find(measurements, m, reference)
    return other["total"]["median"] / m["total"]["median"] if other else 0.0


def markdown_table(heading, rows):
    def line(row):
        return "| %s |\n" % " | ".join(str(cell) for cell in row)
    return line(heading) + "|---|" + "--:|" * (len(heading) - 1) + "\n" + "".join(line(row) for row in rows)


def csv_table(heading, rows):
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows([heading] + rows)
    return text.getvalue()


def stage_table(data):
    shown = [m for m in data["frames"] if m["stages"] and m["method"] not in ("paper_3", "paper_5")]
    return markdown_table(
        ["frame", "method"] + data["stage_names"] + ["total"],
        [[frame_of(m), m["method"]] + [three_digits(m["stages"][s]["median"]) for s in data["stage_names"]] +
         [three_digits(m["total"]["median"])] for m in shown])


def median_table(measurements, methods):
    rows = []
    for frame in {frame_of(m): m for m in measurements}.values():
        found = [find(measurements, frame, method) for method in methods]
        rows.append([frame_of(frame)] + [three_digits(m["total"]["median"]) if m else "-" for m in found])
    return markdown_table(["frame"] + methods, rows)


def ratio_text(data, measurements, m):
    ratio = ratio_to(data["reference"], measurements, m)
    return three_digits(ratio) if ratio > 0 else "-"


def method_table(data):
    return markdown_table(
        ["frame", "method", "median", "minimum", "maximum", "runs", "planes", data["reference"] + " / it"],
        [[frame_of(m), m["method"]] + [three_digits(m["total"][s]) for s in ("median", "min", "max")] +
         [m["total"]["runs"], m["planes"], ratio_text(data, data["frames"], m)] for m in data["frames"]])


def spread_table(measurements):
    """The worst frame's median over the median of all frames' medians, by method and size."""
    groups = {}
    for m in measurements:
        groups.setdefault((m["method"], size_of(m)), []).append(m["total"]["median"])
    return markdown_table(["method", "size", "median of the frames", "worst frame", "ratio"],
                          [[method, size, three_digits(statistics.median(medians)), three_digits(max(medians)),
                            three_digits(max(medians) / statistics.median(medians))]
                           for (method, size), medians in groups.items()])


def clock_table(measurements):
    """Processor and wall time, cold and warm, with percentiles."""
    heading = ["frame", "method"]
    for name in ("cold", "cold wall", "warm", "warm wall"):
        heading += [name, "90 %", "99 %"]
    rows = []
    for m in measurements:
        row = [frame_of(m), m["method"]]
        for key in ("cold", "cold_wall", "warm", "warm_wall"):
            row += [three_digits(m[key][s]) for s in ("median", "p90", "p99")] if m.get(key) else ["-"] * 3
        rows.append(row)
    return markdown_table(heading, rows)


def scaling_table(data, measurements, unit, amount):
    return markdown_table(
        ["frame", "method", "median", "planes found", unit, data["reference"] + " / it"],
        [[frame_of(m), m["method"], three_digits(m["total"]["median"]), m["planes"],
          three_digits(m["total"]["median"] * 1e3 / amount(m)), ratio_text(data, measurements, m)]
         for m in measurements])


def camera_table(loads):
    return markdown_table(
        ["cameras", "a frame of each", "per camera", "rounds per second"],
        [[load["cameras"], three_digits(load["round"]["median"]),
          three_digits(load["round"]["median"] / load["cameras"]), three_digits(1e3 / load["round"]["median"])]
         for load in loads])


def kilopixels(m):
    return m["width"] * m["height"] * 1e-3


def planes_or_one(m):
    return max(1, m["planes"])


def markdown(data):
    frames = data["frames"]
    sections = [
        ("Stages (the paper's Table 1)", stage_table(data)),
        ("1, 3 and 5 points per segment (Table 2)", median_table(frames, ["paper_1", "paper_3", "paper_5"])),
        ("VGA and QVGA (Table 3)", median_table(frames, ["adaptive", "paper_1", "omps", "omps_refined"])),
        ("All methods (Table 4)", method_table(data)),
        ("Worst frame", spread_table(frames)),
        ("Cold and warm, processor and wall time", clock_table(frames))]
    if data["sizes"]:
        sections.append(("Size of the image", scaling_table(data, data["sizes"], "µs per kilopixel", kilopixels)))
    if data["planes"]:
        sections.append(("Number of planes", scaling_table(data, data["planes"], "µs per plane found", planes_or_one)))
    if data["cameras"]:
        sections.append(("Cameras on one core", camera_table(data["cameras"])))
    head = data["machine"] + "\nAll times in milliseconds, medians unless stated otherwise.\n"
    return head + "".join("\n### %s\n\n%s" % section for section in sections)


def times_csv(data):
    """One row for each method on each frame."""
    heading = ["frame", "width", "height", "method", "median_ms", "min_ms", "max_ms", "runs", "planes",
               data["reference"] + "_ratio", "p90_ms", "p99_ms"]
    clocks = ["cold", "cold_wall", "warm", "warm_wall"]
    rows = []
    for m in data["frames"]:
        total = m["total"]
        rows.append([m["frame"], m["width"], m["height"], m["method"]] +
                    ["%.6f" % total[s] for s in ("median", "min", "max")] + [total["runs"], m["planes"]] +
                    ["%.6f" % ratio_to(data["reference"], data["frames"], m)] +
                    ["%.6f" % total[s] for s in ("p90", "p99")] +
                    ["%.6f" % m[clock]["median"] if m.get(clock) else "" for clock in clocks])
    return csv_table(heading + [clock + "_ms" for clock in clocks], rows)


def stages_csv(data):
    """One row for each stage of this package's methods on each frame."""
    return csv_table(["frame", "width", "height", "method", "stage", "median_ms", "min_ms", "max_ms", "runs"],
                     [[m["frame"], m["width"], m["height"], m["method"], stage] +
                      ["%.6f" % m["stages"][stage][s] for s in ("median", "min", "max")] + [m["stages"][stage]["runs"]]
                      for m in data["frames"] if m["stages"] for stage in data["stage_names"]])


def messages(data):
    """messages.md of benchmark_messages."""
    rows = [[f["frame"], size_of(f), f["planes"]] +
            [three_digits(f[name]["median"]) for name in ("segmenter", "answered", "ratio", "all_answered", "all_ratio")]
            for f in data["frames"]]
    worst, worst_all = (max(f[name]["median"] for f in data["frames"]) for name in ("ratio", "all_ratio"))
    return (data["machine"] +
            "- Wall time in milliseconds, and ratios to the segmenter's own time in the same round; medians of "
            "%d rounds\n"
            "- From publishing the image in this process until its subscriber has the `PlaneArray`, with no other "
            "subscriber; and until subscribers to all six topics have everything\n\n%s"
            "\nThe largest ratios: %s to the `PlaneArray`, %s with all topics.\n" %
            (data["frames"][0]["ratio"]["runs"],
             markdown_table(["frame", "size", "planes", "segmenter", "to `PlaneArray`", "ratio", "all topics", "ratio"],
                            rows), three_digits(worst), three_digits(worst_all)))
