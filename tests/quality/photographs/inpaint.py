"""Fills a hole by both methods of OpenCV: inpaint.py PICTURE HOLE TELEA NAVIER_STOKES, paths of PNG files."""

import sys

import cv2

# Pixels around a pixel that count, as in the example of OpenCV's documentation.
RADIUS = 3

picture, hole, telea, navier_stokes = sys.argv[1:]
colours = cv2.imread(picture, cv2.IMREAD_COLOR)
mask = cv2.imread(hole, cv2.IMREAD_GRAYSCALE)
for path, method in [(telea, cv2.INPAINT_TELEA), (navier_stokes, cv2.INPAINT_NS)]:
    if not cv2.imwrite(path, cv2.inpaint(colours, mask, RADIUS, method)):
        sys.exit(f"{path} cannot be written")
