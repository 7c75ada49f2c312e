# SPDX-License-Identifier: Apache-2.0
"""A headless Chromium that a test drives like a user: mouse, keys, files in and out.

It speaks Chromium's DevTools protocol over the pipe of --remote-debugging-pipe: messages of JSON
that end in a zero byte, so no driver, socket or package is needed."""

import argparse
import base64
import fcntl
import json
import os
import pathlib
import select
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

OPTIONS = argparse.Namespace()  # of run_tests()
TIMEOUT = 900  # s, for any one answer
ENTER = {"key": "Enter", "code": "Enter", "windowsVirtualKeyCode": 13}


class BrowserError(Exception):
    pass


class Chromium:
    def __init__(self, width=1400, height=1800):
        program = shutil.which("chromium")
        if program is None:
            raise BrowserError("chromium is missing: run scripts/setup.sh")
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="curvecore-chromium."))
        self.downloads = self.folder / "downloads"
        self.downloads.mkdir()
        child_in, self.out = os.pipe()
        self.inp, child_out = os.pipe()
        ends = [fcntl.fcntl(end, fcntl.F_DUPFD, 10) for end in (child_in, child_out)]

        def pipes():
            os.dup2(ends[0], 3)
            os.dup2(ends[1], 4)

        # Without its sandbox, which root may not have: it opens this test's own pages only.
        self.process = subprocess.Popen(
            [program, "--headless=new", "--no-sandbox", "--disable-gpu", "--no-first-run",
             "--disable-dev-shm-usage", "--remote-debugging-pipe", "--hide-scrollbars",
             f"--window-size={width},{height}", f"--user-data-dir={self.folder / 'profile'}",
             "about:blank"],
            preexec_fn=pipes, pass_fds=(3, 4), stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL, start_new_session=True)
        for end in (child_in, child_out, *ends):
            os.close(end)
        self.buffer = b""
        self.count = 0
        self.session = None
        self.events = []
        target = self.send("Target.createTarget", url="about:blank")["targetId"]
        attached = self.send("Target.attachToTarget", targetId=target, flatten=True)
        self.send("Browser.setDownloadBehavior", behavior="allow",
                  downloadPath=str(self.downloads))
        self.session = attached["sessionId"]
        for domain in ("Page", "Runtime", "Network", "DOM"):
            self.send(f"{domain}.enable")
        self.send("Emulation.setDeviceMetricsOverride", width=width, height=height,
                  deviceScaleFactor=1, mobile=False)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
        os.close(self.out)
        os.close(self.inp)
        shutil.rmtree(self.folder, ignore_errors=True)

    def receive(self, deadline):
        while b"\0" not in self.buffer:
            ready, _, _ = select.select([self.inp], [], [], max(0, deadline - time.monotonic()))
            part = os.read(self.inp, 1 << 20) if ready else b""
            if not part:
                raise BrowserError("Chromium ended" if ready else "Chromium does not answer")
            self.buffer += part
        message, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(message)

    def send(self, method, **params):
        self.count += 1
        message = {"id": self.count, "method": method, "params": params}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.out, json.dumps(message).encode() + b"\0")
        deadline = time.monotonic() + TIMEOUT
        while True:
            answer = self.receive(deadline)
            if answer.get("id") != self.count:
                self.events.append(answer)
            elif "error" in answer:
                raise BrowserError(f"{method}: {answer['error']['message']}")
            else:
                return answer["result"]

    def open(self, page):
        """Opens a file, or an address of http."""
        page = str(page)
        address = page if page.startswith("http:") else pathlib.Path(page).resolve().as_uri()
        self.events = [event for event in self.events if "Network" in event.get("method", "")]
        self.send("Page.navigate", url=address)
        deadline = time.monotonic() + TIMEOUT
        while not any(event.get("method") == "Page.loadEventFired" for event in self.events):
            self.events.append(self.receive(deadline))

    def get(self, expression):
        """Returns the value of an expression in the page."""
        found = self.send("Runtime.evaluate", expression=expression, returnByValue=True,
                          awaitPromise=True)
        if "exceptionDetails" in found:
            details = found["exceptionDetails"]
            raise BrowserError(details.get("exception", details).get("description", details))
        return found["result"].get("value")

    def wider_than(self, width):
        """Returns elements of the page that reach beyond its width, and do not scroll."""
        return self.get(f"""[...document.querySelectorAll("body *")]
            .filter((e) => !e.closest(".wide, .scroll") &&
                e.getBoundingClientRect().right > {width} + 0.5)
            .map((e) => e.tagName + "#" + e.id + "." + e.className).slice(0, 5)""")

    def picture(self, file, **options):
        shot = self.send("Page.captureScreenshot", **options)["data"]
        pathlib.Path(file).write_bytes(base64.b64decode(shot))

    def errors(self):
        """Returns the errors that the page's own scripts threw."""
        return [event["params"]["exceptionDetails"] for event in self.events
                if event.get("method") == "Runtime.exceptionThrown"]

    def addresses(self):
        """Returns all requests except files and objects that the page made itself."""
        wanted = [event["params"]["request"]["url"] for event in self.events
                  if event.get("method") == "Network.requestWillBeSent"]
        return [url for url in wanted if not url.startswith(("file:", "blob:", "data:", "about:"))]

    def middle(self, selector):
        return self.get(f"""(() => {{
            const e = document.querySelector({json.dumps(selector)});
            e.scrollIntoView({{block: "center"}});
            const b = e.getBoundingClientRect();
            return [b.x + b.width / 2, b.y + b.height / 2];
        }})()""")

    def mouse(self, kind, x, y, buttons=0):
        self.send("Input.dispatchMouseEvent", type=kind, x=x, y=y, buttons=buttons,
                  button="none" if kind == "mouseMoved" else "left", clickCount=1)

    def click(self, selector):
        x, y = self.middle(selector)
        self.mouse("mousePressed", x, y, 1)
        self.mouse("mouseReleased", x, y)

    def drag(self, start, end, steps=5):
        self.mouse("mousePressed", *start, 1)
        for i in range(1, steps + 1):
            self.mouse("mouseMoved", *[a + (b - a) * i / steps for a, b in zip(start, end)], 1)
        self.mouse("mouseReleased", *end)

    def type(self, selector, text):
        """Replaces the text of a field, and presses Enter."""
        self.click(selector)
        self.get(f"document.querySelector({json.dumps(selector)}).select()")
        self.send("Input.insertText", text=text)
        self.send("Input.dispatchKeyEvent", type="rawKeyDown", text="\r", **ENTER)
        self.send("Input.dispatchKeyEvent", type="char", text="\r", **ENTER)
        self.send("Input.dispatchKeyEvent", type="keyUp", **ENTER)

    def choose(self, selector, value):
        self.get(f"""(() => {{
            const e = document.querySelector({json.dumps(selector)});
            e.value = {json.dumps(value)};
            e.dispatchEvent(new Event("change"));
        }})()""")

    def download(self, selector, name):
        """Clicks, and waits for the file."""
        file = self.downloads / name
        file.unlink(missing_ok=True)
        self.click(selector)
        deadline = time.monotonic() + TIMEOUT
        while not file.exists() or file.stat().st_size == 0:
            if time.monotonic() > deadline:
                raise BrowserError(f"{name} was not saved")
            time.sleep(0.02)
        return file

    def upload(self, selector, file):
        root = self.send("DOM.getDocument")["root"]["nodeId"]
        node = self.send("DOM.querySelector", nodeId=root, selector=selector)["nodeId"]
        self.send("DOM.setFileInputFiles", nodeId=node, files=[str(file)])


def run_tests(description):
    """Runs the tests of the script, with the options of its line in OPTIONS."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--program", type=pathlib.Path, required=True)
    parser.add_argument("--pictures", type=pathlib.Path, help="folder for what was seen")
    _, rest = parser.parse_known_args(namespace=OPTIONS)
    OPTIONS.program = OPTIONS.program.resolve()
    unittest.main("__main__", argv=[sys.argv[0], *rest], verbosity=2)
