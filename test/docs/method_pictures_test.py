#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/method_pictures.py draws every stage, and doc/method.md shows each picture that it draws and no other."""
import pathlib
import re
import unittest

from PIL import Image

from pages import Made, ROOT

MAX_BYTES = 60000


class MethodPictures(unittest.TestCase):
    def test_draws_the_pictures_of_the_page(self):
        with Made("method_pictures.py") as folder:
            drawn = {path.stem: Image.open(path).copy() for path in pathlib.Path(folder).glob("*.png")}
        self.assertLessEqual({"scanlines", "line_segments", "candidates", "extraction", "labels", "refinement",
                              "outlines"}, set(drawn))
        for name, picture in drawn.items():
            half = picture.width // 2
            for panel in (picture.crop((0, 0, half, picture.height)), picture.crop((half, 0, 2 * half, picture.height))):
                self.assertGreater(len(panel.convert("RGB").getcolors(1 << 24)), 8, name + " has an empty panel")

        page = (ROOT / "doc" / "method.md").read_text(encoding="utf-8")
        self.assertEqual(set(drawn), set(re.findall(r"\(method/(\w+)\.png\)", page)))
        committed = {path.stem: path for path in (ROOT / "doc" / "method").glob("*.png")}
        self.assertEqual(set(drawn), set(committed), "run scripts/make_method_pictures")
        for name, path in committed.items():
            self.assertLess(path.stat().st_size, MAX_BYTES, name)
            with Image.open(path) as picture:
                self.assertEqual((drawn[name].size, "P"), (picture.size, picture.mode), name)


if __name__ == "__main__":
    unittest.main()
