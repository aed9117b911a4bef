"""Paintings of drawing files by programs that share no code with Relievo."""

import base64
import gzip
import io
import json
import os
import re
import subprocess
import tempfile
import zipfile

import psd_tools
from PIL import Image, ImageOps

# Formats that Pillow reads.
PICTURES = {".png", ".jpg", ".jpeg", ".gif", ".webp"}


class Browser:
    """A headless Chromium that is spoken to through pipes."""

    def __init__(self):
        self.home = tempfile.TemporaryDirectory()
        to_browser, self.sink = os.pipe()
        self.source, from_browser = os.pipe()

        def connect():
            # The browser reads from 3 and writes to 4.
            first, second = os.dup(to_browser), os.dup(from_browser)
            os.dup2(first, 3)
            os.dup2(second, 4)

        self.process = subprocess.Popen(
            [
                "chromium",
                "--headless",
                "--no-sandbox",
                "--disable-gpu",
                "--hide-scrollbars",
                "--allow-file-access-from-files",
                "--remote-debugging-pipe",
                f"--user-data-dir={self.home.name}",
            ],
            preexec_fn=connect,
            close_fds=False,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        os.close(to_browser)
        os.close(from_browser)
        self.buffer = b""
        self.count = 0
        self.session = None
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)[
            "sessionId"
        ]
        self.call(
            "Emulation.setDefaultBackgroundColorOverride", color={"r": 0, "g": 0, "b": 0, "a": 0}
        )

    def call(self, method, **parameters):
        """Sends a command and returns its result; events are left unread."""
        self.count += 1
        message = {"id": self.count, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.sink, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.next_message()
            if answer.get("id") == self.count:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']['message']}")
                return answer["result"]

    def next_message(self):
        while b"\0" not in self.buffer:
            read = os.read(self.source, 1 << 20)
            if not read:
                raise RuntimeError("the browser has ended")
            self.buffer += read
        message, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(message)

    def paint(self, svg, size):
        """Returns an SVG, as bytes, stretched over a picture, or None where it shows none."""
        width, height = size
        self.call(
            "Emulation.setDeviceMetricsOverride",
            width=width,
            height=height,
            deviceScaleFactor=1,
            mobile=False,
        )
        shown = self.call(
            "Runtime.evaluate",
            awaitPromise=True,
            returnByValue=True,
            expression=f"""(async () => {{
                document.documentElement.innerHTML = "<body style='margin:0'></body>";
                const image = new Image();
                image.style = "display:block;width:{width}px;height:{height}px";
                image.src = "data:image/svg+xml;base64,{base64.b64encode(svg).decode()}";
                document.body.append(image);
                try {{ await image.decode(); }} catch (_) {{ return null; }}
                return [image.naturalWidth, image.naturalHeight];
            }})()""",
        )["result"].get("value")
        if not shown:
            return None
        shot = self.call("Page.captureScreenshot", format="png")["data"]
        return Image.open(io.BytesIO(base64.b64decode(shot))).convert("RGBA")

    def close(self):
        self.process.terminate()
        self.process.wait()
        os.close(self.sink)
        os.close(self.source)
        self.home.cleanup()


def fitted(picture, size):
    """Returns a picture as RGBA of a size, or None where its proportions are other ones."""
    if picture is None:
        return None
    upright = ImageOps.exif_transpose(picture).convert("RGBA").convert("RGBa")
    return upright.resize(size, Image.Resampling.BOX).convert("RGBA")


def merged_picture(file):
    """Returns the merged picture of a painting of layers, None where it holds none."""
    if file.suffix == ".ora":
        with zipfile.ZipFile(file) as archive:
            return Image.open(io.BytesIO(archive.read("mergedimage.png")))
    picture = psd_tools.PSDImage.open(file).topil().convert("RGBA")
    # Programs that save no merged picture leave an even one.
    shows_something = any(low < high for low, high in picture.getextrema())
    return picture if shows_something else None


class Painter:
    """Paints files; its browser starts with the first SVG."""

    def __init__(self):
        self.browser = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.browser:
            self.browser.close()

    def paint(self, file, size):
        """Returns a file's picture as RGBA of a size, or None where it cannot be painted."""
        if file.suffix in (".svg", ".svgz"):
            data = file.read_bytes()
            if data[:2] == b"\x1f\x8b":
                data = gzip.decompress(data)
            if not re.search(rb"<svg[^>]*\sxmlns=", data):
                data = re.sub(rb"<svg\b", b'<svg xmlns="http://www.w3.org/2000/svg"', data, count=1)
            self.browser = self.browser or Browser()
            return self.browser.paint(data, size)
        try:
            picture = Image.open(file) if file.suffix in PICTURES else merged_picture(file)
            return fitted(picture, size)
        except Exception:  # of the many that readers of damaged files raise
            return None
