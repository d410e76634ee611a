#!/usr/bin/python3
"""usage: panels.py OUT.png COLUMNS WIDTH IN.png[@LEFT,TOP,WIDTH,HEIGHT][=CAPTION]...

Arranges pictures side by side, each WIDTH pixels wide, COLUMNS per row, as a small PNG of at most 256 colors, including rare ones
of marks. @ selects a part of a picture. Called by make-figures.
"""
import sys

from PIL import Image, ImageDraw

GAP, CAPTION = 6, 16


def panel_of(argument, width):
    """Returns the picture of an argument and its caption."""
    path, _, caption = argument.partition("=")
    path, _, part = path.partition("@")
    picture = Image.open(path).convert("RGB")
    if part:
        left, top, across, down = map(int, part.split(","))
        picture = picture.crop((left, top, left + across, top + down))
    height = round(picture.height * width / picture.width)
    return picture.resize((width, height), Image.Resampling.LANCZOS), caption


def sheet_of(panels, columns, width):
    """Arranges all panels on white, each below its caption."""
    rows = [panels[i:i + columns] for i in range(0, len(panels), columns)]
    head = CAPTION if any(caption for _, caption in panels) else 0
    heights = [max(picture.height for picture, _ in row) + head for row in rows]
    sheet = Image.new("RGB", (len(rows[0]) * (width + GAP) - GAP, sum(heights) + GAP * (len(rows) - 1)), "white")
    draw, top = ImageDraw.Draw(sheet), 0
    for row, height in zip(rows, heights):
        for column, (picture, caption) in enumerate(row):
            draw.text((column * (width + GAP), top), caption, fill=(30, 32, 38))
            sheet.paste(picture, (column * (width + GAP), top + head))
        top += height + GAP
    return sheet


def main():
    if "--help" in sys.argv[1:2]:
        print(__doc__)
        return
    out, columns, width = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    sheet = sheet_of([panel_of(argument, width) for argument in sys.argv[4:]], columns, width)
    sheet.quantize(256, method=Image.Quantize.MAXCOVERAGE, kmeans=1).save(out, optimize=True)


if __name__ == "__main__":
    main()
