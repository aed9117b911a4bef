"""Sources of layered drawings: packages of Debian and npm, each with the split of its artists.

Nothing of them is kept in the repository. Twemoji and the penguin Tux are left out: drawings of
theirs judge the final results.
"""

import hashlib
import json
import pathlib
import re
import subprocess

SPLITS = ("tuning", "validation", "test")

# Sets of pictures on npm, each by one hand. Sets of one maker have the same split.
EMOJI = {
    "noto": "tuning",
    "noto-v1": "tuning",
    "openmoji": "tuning",
    "fluent-emoji-flat": "validation",
    "fxemoji": "validation",
    "emojione": "test",
    "emojione-v1": "test",
    "streamline-emojis": "test",
}
EMOJI_KINDS = re.compile("animal|nature|people|person|smiley", re.IGNORECASE)
# Variants of another picture.
EMOJI_VARIANTS = re.compile("skin|light|dark|medium|tone|hair|facing|flag")

# Makers of characters on npm.
AVATARS = {
    "adventurer": "tuning",
    "avataaars": "validation",
    "bigEars": "test",
    "bigSmile": "tuning",
    "bottts": "validation",
    "croodles": "test",
    "dylan": "tuning",
    "funEmoji": "validation",
    "lorelei": "test",
    "micah": "tuning",
    "miniavs": "validation",
    "notionists": "test",
    "openPeeps": "tuning",
    "personas": "validation",
    "toonHead": "test",
}
AVATARS_EACH = 60

# Packages of Debian with drawings, each by one group of artists, except clip art, whose files name
# their artist.
DEBIAN = {
    "gcompris-qt-data": "tuning",
    "ktuberling": "validation",
    "ktuberling-data": "validation",
    "khangman": "test",
    "granatier": "validation",
    "kapman": "test",
    "tuxpaint-stamps-default": "test",
}
CLIP_ART = "openclipart-svg"
CLIP_ART_KINDS = ("animals", "people", "recreation")
CREATOR = re.compile(r"<dc:creator>.*?<dc:title>\s*([^<]+?)\s*</dc:title>", re.DOTALL)

MOST_OF_ONE_HAND = 150


def number_of(text):
    return int(hashlib.sha256(text.encode()).hexdigest()[:12], 16)


def split_of(artist):
    """Returns the split of an artist for whom no table has one."""
    return SPLITS[number_of(artist.lower()) % len(SPLITS)]


def chosen(drawings, most=MOST_OF_ONE_HAND):
    """Returns at most so many drawings of one hand, the same ones every time."""
    return sorted(drawings, key=lambda one: number_of(one[0]))[:most]


def install_npm(folder, packages):
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "package.json").write_text('{"private": true, "type": "module"}')
    words = ["npm", "install", "--ignore-scripts", "--no-audit", "--no-fund", "--silent"]
    subprocess.run([*words, *packages], cwd=folder, check=True)


def emoji(folder):
    """Yields (split, artist, name, SVG) of the sets of pictures."""
    install_npm(folder, [f"@iconify-json/{name}" for name in EMOJI])
    for name, split in EMOJI.items():
        package = folder / "node_modules/@iconify-json" / name
        pictures = json.loads((package / "icons.json").read_text())
        stated = json.loads((package / "metadata.json").read_text()).get("categories", {})
        kept = {
            one
            for kind, names in stated.items()
            if EMOJI_KINDS.search(kind)
            for one in names
            if one in pictures["icons"] and not EMOJI_VARIANTS.search(one)
        }
        drawings = []
        for one in sorted(kept):
            icon = pictures["icons"][one]
            width = icon.get("width", pictures.get("width", 16))
            height = icon.get("height", pictures.get("height", 16))
            head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}">'
            drawings.append((one, head + icon["body"] + "</svg>"))
        for one, svg in chosen(drawings):
            yield split, name, one, svg


MAKE_AVATARS = """
import { createAvatar } from '@dicebear/core';
import * as styles from '@dicebear/collection';
const [names, each] = [process.argv[2].split(','), Number(process.argv[3])];
const made = names.flatMap((name) => Array.from({ length: each }, (_, seed) =>
  ({ name, seed, svg: createAvatar(styles[name], { seed: `${seed}` }).toString() })));
console.log(JSON.stringify(made));
"""


def avatars(folder):
    """Yields (split, artist, name, SVG) of made characters."""
    install_npm(folder, ["@dicebear/core", "@dicebear/collection"])
    (folder / "make.mjs").write_text(MAKE_AVATARS)
    words = ["node", "make.mjs", ",".join(AVATARS), str(AVATARS_EACH)]
    made = subprocess.run(words, cwd=folder, check=True, capture_output=True, text=True).stdout
    for one in json.loads(made):
        yield AVATARS[one["name"]], one["name"], f"{one['seed']}", one["svg"]


def unpacked(folder, package):
    """Unpacks a package of Debian without installing it."""
    place = folder / package
    if not place.exists():
        folder.mkdir(parents=True, exist_ok=True)
        subprocess.run(["apt-get", "download", "-qq", package], cwd=folder, check=True)
        (file,) = folder.glob(f"{package}_*.deb")
        subprocess.run(["dpkg-deb", "-x", file, place], check=True)
        file.unlink()
    return place


def drawings_below(place):
    for file in sorted(place.rglob("*.svg")):
        if "tux" not in file.name.lower() and not file.is_symlink():
            yield file, file.read_text(errors="replace")


def debian(folder):
    """Yields (split, artist, name, SVG) of drawings in packages of Debian."""
    for package, split in DEBIAN.items():
        drawings = [(file.stem, svg) for file, svg in drawings_below(unpacked(folder, package))]
        for name, svg in chosen(drawings):
            yield split, package, name, svg
    by_artist = {}
    for kind in CLIP_ART_KINDS:
        place = unpacked(folder, CLIP_ART) / "usr/share/openclipart/svg" / kind
        for file, svg in drawings_below(place):
            named = CREATOR.search(svg)
            artist = named[1] if named else "unknown"
            by_artist.setdefault(artist.lower(), []).append((file.stem, svg))
    for artist, drawings in sorted(by_artist.items()):
        for name, svg in chosen(drawings):
            yield split_of(artist), artist, name, svg


def all_drawings(folder: pathlib.Path):
    yield from emoji(folder / "emoji")
    yield from avatars(folder / "avatars")
    yield from debian(folder / "debian")
