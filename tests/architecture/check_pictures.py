"""Pictures of the guides hold a picture and nothing else: tools note their command lines in them, folders of one machine
and all.

Usage: check_pictures.py ROOT.  Exit 1 with a line per offence.
"""
import sys
from pathlib import Path

START_OF_SCAN = 0xDA
COMMENT = 0xFE
APPLICATION = range(0xE1, 0xF0)  # Exif, XMP, IPTC; 0xE0 is JFIF's own


def markers(jpeg):
    """Of all segments before the picture itself."""
    found, at = [], 2
    while at + 4 <= len(jpeg) and jpeg[at] == 0xFF and jpeg[at + 1] != START_OF_SCAN:
        found.append(jpeg[at + 1])
        at += 2 + int.from_bytes(jpeg[at + 2 : at + 4], "big")
    return found


def main(root):
    pictures = sorted((root / "assets/pictures").glob("*.jpg"))
    if not pictures:
        sys.exit(f"{root}/assets/pictures: no pictures to look at")
    talkative = [p for p in pictures if any(m == COMMENT or m in APPLICATION for m in markers(p.read_bytes()))]
    for picture in talkative:
        print(f"{picture}: holds words beside the picture (Exif or a comment); write it without them")
    sys.exit(1 if talkative else 0)


main(Path(sys.argv[1]))
