#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/tuning_page.py has a picture of each parameter that changes an image, and doc/tuning.md is up to date."""
import pathlib
import re
import unittest

from line_plane_segmentation import PlaneSegmenter
from pages import Made, ROOT


def facts(page):
    """What a page says of each parameter, without its pictures."""
    return [line for line in page.splitlines() if re.match(r"##|\[[^\]]*\] |Default: ", line)]


class TuningPage(unittest.TestCase):
    def test_is_made_of_all_parameters(self):
        with Made("tuning_page.py") as folder:
            page = pathlib.Path(folder, "tuning.md").read_text(encoding="utf-8")
            pictures = {path.stem for path in pathlib.Path(folder, "tuning").glob("*.png")}
        headings = set(re.findall(r"^### (\w+)$", page, re.MULTILINE))
        self.assertEqual(set(PlaneSegmenter().parameters) - {"method"}, headings)
        self.assertEqual(set(re.findall(r"\(tuning/(\w+)\.png\)", page)), pictures)
        self.assertLessEqual({"patch_noise_factor", "min_plane_inliers", "max_range", "line_fidelity"}, pictures)

        committed = (ROOT / "doc" / "tuning.md").read_text(encoding="utf-8")
        self.assertEqual(facts(page), facts(committed), "run scripts/make_tuning_page")
        for name in re.findall(r"\(tuning/(\w+)\.png\)", committed):
            self.assertTrue((ROOT / "doc" / "tuning" / (name + ".png")).exists(), name)


if __name__ == "__main__":
    unittest.main()
