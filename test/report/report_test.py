# SPDX-License-Identifier: BSD-3-Clause
"""src/report: the tools' pages, plots and tables."""

import csv
import io
import json
import pathlib
import subprocess
import sys

import PIL.Image
import pytest

PROGRAM = pathlib.Path(__file__).parents[2] / "src/report"
sys.path.insert(0, str(PROGRAM))

import page  # noqa: E402
import tables  # noqa: E402


def make(kind, data):
    """What the program prints, run as the tools run it."""
    return subprocess.run([sys.executable, "-B", str(PROGRAM), kind], input=json.dumps(data).encode(),
                          stdout=subprocess.PIPE, check=True).stdout


def statistic(median):
    return {"median": median, "min": median / 2, "max": median * 2, "p90": median * 1.5, "p99": median * 1.8, "runs": 20}


def measured(frame, width, method, median, stages=()):
    times = {name: statistic(median) for name in ("total", "cold", "cold_wall", "warm", "warm_wall")}
    return {"frame": frame, "width": width, "height": width * 3 // 4, "method": method, "planes": 4,
            "stages": {name: statistic(median / 2) for name in stages}, **times}


def two_sizes():
    frames = [measured("hall", 640, "adaptive", 1.0, ["lines"]), measured("hall", 640, "omps", 80.0),
              measured("hall", 320, "adaptive", 0.25, ["lines"]), measured("hall", 320, "omps", 15.0)]
    return {"reference": "omps", "stage_names": ["lines"], "machine": "- a machine\n", "frames": frames, "sizes": [],
            "planes": [], "cameras": []}


def test_ratio_is_of_the_same_frame_and_size():
    frames = two_sizes()["frames"]
    assert [tables.ratio_to("omps", frames, frames[i]) for i in (0, 2, 3)] == [80.0, 60.0, 1.0]
    assert tables.ratio_to("omps", frames[:1], frames[0]) == 0.0


@pytest.mark.parametrize("number, text", [(0.01234, "0.012"), (0.1234, "0.123"), (1.234, "1.23"), (12.34, "12.3"),
                                          (1234.4, "1234")])
def test_three_digits(number, text):
    assert tables.three_digits(number) == text


def test_markdown_compares_on_the_same_frame():
    text = make("markdown", two_sizes()).decode()
    assert "| hall, 640x480 | adaptive | 1.00 | 0.500 | 2.00 | 20 | 4 | 80.0 |\n" in text
    assert "| hall, 640x480 | adaptive | 0.500 | 1.00 |\n" in text, "stages"
    assert "| hall, 320x240 | - | - | - |\n" in text, "methods left out"
    assert "| hall, 640x480 | adaptive | 1.00 | 1.50 | 1.80 | 1.00 | 1.50 | 1.80 |" in text, "percentiles"
    assert "Cameras" not in text, "not measured"
    with_cameras = dict(two_sizes(), cameras=[{"cameras": 2, "round": statistic(4.0)}])
    assert "| 2 | 4.00 | 2.00 | 250 |\n" in tables.markdown(with_cameras)


def test_slow_methods_have_no_warm_times():
    data = two_sizes()
    del data["frames"][1]["warm"], data["frames"][1]["warm_wall"]
    assert "| hall, 640x480 | omps | 80.0 | 120 | 144 | 80.0 | 120 | 144 | - | - | - | - | - | - |" in tables.markdown(data)


def test_times_csv_has_a_row_for_each_measurement():
    data = two_sizes()
    data["frames"][2]["frame"] = 'a "hall", again'
    rows = list(csv.DictReader(io.StringIO(make("times_csv", data).decode())))
    assert len(rows) == 4
    assert rows[2]["frame"] == 'a "hall", again'
    assert rows[1] == {"frame": "hall", "width": "640", "height": "480", "method": "omps", "median_ms": "80.000000",
                       "min_ms": "40.000000", "max_ms": "160.000000", "runs": "20", "planes": "4",
                       "omps_ratio": "1.000000", "p90_ms": "120.000000", "p99_ms": "144.000000",
                       "cold_ms": "80.000000", "cold_wall_ms": "80.000000", "warm_ms": "80.000000",
                       "warm_wall_ms": "80.000000"}


def test_stages_csv():
    lines = tables.stages_csv(two_sizes()).splitlines()
    assert lines[1:] == ["hall,640,480,adaptive,lines,0.500000,0.250000,1.000000,20",
                         "hall,320,240,adaptive,lines,0.125000,0.062500,0.250000,20"]


def image_of(png):
    return PIL.Image.open(io.BytesIO(png)).convert("RGB")


def test_times_shows_the_first_size_alone():
    data = two_sizes()
    first = image_of(make("times", data))
    assert first == image_of(make("times", dict(data, frames=data["frames"][:2])))
    assert first != image_of(make("times", dict(data, frames=[data["frames"][0], measured("hall", 640, "omps", 800.0)])))


def curve(counts):
    points = [dict(c, tolerance=t) for c, t in zip(counts, (0.6, 0.9))]
    return {"tolerance": 0.8, "set": counts[0], "curve": points}


def test_curve_shows_the_counts():
    good = dict(truth_regions=10, label_regions=10, correct=10, over_segmented=0, merged=0, missed=0, noise=0)
    bad = dict(good, correct=0, missed=10, noise=10)
    flat = image_of(make("curve", curve([good, good])))
    assert flat != image_of(make("curve", curve([good, bad])))
    empty = dict.fromkeys(good, 0)
    assert image_of(make("curve", curve([empty, empty]))).size == flat.size


def test_sheet_has_a_row_for_each_frame(tmp_path):
    PIL.Image.new("RGB", (640, 480), "red").save(tmp_path / "a.png")
    file = list(bytes(tmp_path / "a.png"))
    picture = image_of(make("sheet", {"rows": ["1", "2", "3"], "columns": ["x", "y"], "pictures": [[file, file]] * 3}))
    assert picture.width >= 2 * 320 and picture.height >= 3 * 240
    assert picture.getcolors()[0][0] and dict((color, n) for n, color in picture.getcolors())[(255, 0, 0)] == 6 * 320 * 240


def write_frame(folder, name, total, planes=1):
    plane = {"label": 1, "normal": [0, 0, -1], "d": 2.4, "area": 1.0, "rms": 0.001, "inliers": 5}
    document = {"frame": name, "planes": [plane] * planes, "milliseconds": {"lines": total, "total": total}}
    (folder / "f.json").write_text(json.dumps(document))
    return (folder / "f.json").read_text()


def page_data(folder, totals):
    PIL.Image.new("RGB", (8, 6)).save(folder / "overlay.png")
    frames = []
    for i, total in enumerate(totals):
        file = folder / ("%d.json" % i)
        file.write_text(write_frame(folder, "<frame %d>" % i, total, planes=i % 2))
        frames.append({"planes": list(bytes(file)), "overlay": list(bytes(folder / "overlay.png"))})
    return {"parameters": {"min_range": 0.5, "max_range": 4.0}, "defaults": {"min_range": 0.4, "max_range": 4.0},
            "stages": ["lines"], "colors": [[1, 2, 3]] * 60, "frames": frames}


def test_page_has_the_median_of_an_even_number_of_frames(tmp_path):
    text = make("html", page_data(tmp_path, [2.0, 43.63, 2.65, 100.0])).decode()
    assert "<b>23.14 ms</b>per frame (median)" in text
    assert "<b>100.00 ms</b>slowest frame" in text
    assert "Parameters: min_range = 0.5." in text
    assert "<h2>&lt;frame 3&gt;</h2>" in text and "<frame 3>" not in text


def test_page_shows_an_even_selection_of_many_overlays(tmp_path):
    text = page.html(page_data(tmp_path, [1.0] * 401)).decode()
    assert text.count("<article") == 401
    assert text.count("<img ") == 200
    assert "Overlays of 200 of the 401 frames are shown" in text
    assert text.count("<a href=") == 300


def test_page_of_one_frame_without_planes(tmp_path):
    text = page.html(page_data(tmp_path, [0.0])).decode()
    assert "No planes." in text and "the slowest" not in text


def test_a_missing_file_is_named(tmp_path):
    data = page_data(tmp_path, [1.0])
    (tmp_path / "0.json").unlink()
    result = subprocess.run([sys.executable, "-B", str(PROGRAM), "html"], input=json.dumps(data).encode(),
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
    assert result.returncode == 1 and result.stdout == b""
    assert b"0.json" in result.stderr.splitlines()[-1]


def test_an_unknown_kind_is_refused():
    assert subprocess.run([sys.executable, "-B", str(PROGRAM), "poem"], input=b"{}", stderr=subprocess.PIPE,
                          check=False).returncode == 1
