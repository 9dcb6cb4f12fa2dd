# SPDX-License-Identifier: BSD-3-Clause
"""A sheet of pictures in rows and columns."""

import io
import os

import PIL.Image
import PIL.ImageDraw

CELL = (320, 240)  # [px]
GAP, HEAD, LEFT = 8, 28, 110


def sheet(data):
    """data: "rows" and "columns", their names; "pictures", a list of files for each row, paths as lists of bytes"""
    rows, columns = data["rows"], data["columns"]
    picture = PIL.Image.new("RGB", (LEFT + len(columns) * (CELL[0] + GAP), HEAD + len(rows) * (CELL[1] + GAP)), "white")
    draw = PIL.ImageDraw.Draw(picture)
    for column, name in enumerate(columns):
        draw.text((LEFT + column * (CELL[0] + GAP), 9), name, fill="black")
    for row, name in enumerate(rows):
        top = HEAD + row * (CELL[1] + GAP)
        draw.text((8, top + CELL[1] // 2), name, fill="black")
        for column, file in enumerate(data["pictures"][row]):
            cell = PIL.Image.open(os.fsdecode(bytes(file))).convert("RGB")
            cell.thumbnail(CELL)
            left = LEFT + column * (CELL[0] + GAP)
            picture.paste(cell, (left + (CELL[0] - cell.width) // 2, top + (CELL[1] - cell.height) // 2))
    encoded = io.BytesIO()
    picture.save(encoded, "PNG")
    return encoded.getvalue()
