# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages in headless Chromium: no complaint on the console, formulas have a size, sliders and the mouse move the curve."""

import base64
import json
import os
import shutil
import subprocess
import tempfile
import unittest

from support import FilesTest

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")


class Browser:
    """Chromium, driven through its DevTools protocol over two pipes."""

    def __init__(self, directory):
        to_browser, self.requests = os.pipe()
        self.answers, from_browser = os.pipe()

        def pipes():  # the browser reads from 3 and writes to 4
            read, write = os.dup(to_browser), os.dup(from_browser)
            os.dup2(read, 3)
            os.dup2(write, 4)

        self.process = subprocess.Popen(  # noqa: S603
            [CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars",
             "--remote-debugging-pipe", f"--user-data-dir={directory}", "--window-size=1200,900", "about:blank"],
            preexec_fn=pipes, pass_fds=(3, 4), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)  # noqa: PLW1509
        os.close(to_browser)
        os.close(from_browser)
        self.buffer = b""
        self.count = 0
        self.events = []
        page = next(t for t in self.call("Target.getTargets")["targetInfos"] if t["type"] == "page")
        self.session = None
        self.session = self.call("Target.attachToTarget", targetId=page["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")

    def close(self):
        os.close(self.requests)
        self.process.terminate()
        self.process.wait()
        os.close(self.answers)

    def _message(self):
        while b"\0" not in self.buffer:
            piece = os.read(self.answers, 1 << 16)
            if not piece:
                raise RuntimeError("the browser has ended")
            self.buffer += piece
        message, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(message)

    def call(self, method, **parameters):
        self.count += 1
        request = {"id": self.count, "method": method, "params": parameters}
        if getattr(self, "session", None):
            request["sessionId"] = self.session
        data = json.dumps(request).encode() + b"\0"
        while data:
            data = data[os.write(self.requests, data):]
        while True:
            message = self._message()
            if message.get("id") == self.count:
                if "error" in message:
                    raise RuntimeError(f"{method}: {message['error']}")
                return message["result"]
            self.events.append(message)

    def open(self, path):
        """Loads a page; returns what it complained about and what it asked for."""
        self.events = []
        self.call("Page.navigate", url="file://" + path)
        while not any(e.get("method") == "Page.loadEventFired" for e in self.events):
            self.events.append(self._message())
        self.evaluate("0")

    def complaints(self):
        """Exceptions, errors and warnings on the console, and requests for anything but the page and its own data."""
        found = []
        for e in self.events:
            method, p = e.get("method"), e.get("params", {})
            if method == "Runtime.exceptionThrown":
                found.append(p["exceptionDetails"])
            elif method == "Runtime.consoleAPICalled" and p["type"] in ("error", "warning"):
                found.append(p["args"])
            elif method == "Log.entryAdded":
                found.append(p["entry"]["text"])
            elif method == "Network.requestWillBeSent" and not p["request"]["url"].startswith(("file:", "data:")):
                found.append(p["request"]["url"])
        return found

    def evaluate(self, expression):
        done = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in done:
            raise RuntimeError(f"{expression}: {done['exceptionDetails']}")
        return done["result"].get("value")

    def mouse(self, kind, x, y, **more):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", **more)

    def screenshot(self, path):
        with open(path, "wb") as file:
            file.write(base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"]))


@unittest.skipUnless(CHROMIUM, "chromium is not there")
class Pages(FilesTest):
    def setUp(self):
        super().setUp()
        profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.addCleanup(profile.cleanup)
        self.browser = Browser(profile.name)
        self.addCleanup(self.browser.close)

    def open(self, *report):
        self.twoscale("report", *report, "-o", self.path("page"), "--quiet")
        self.browser.open(self.path("page/index.html"))

    def curve(self):
        return self.browser.evaluate('document.querySelector(".interactive .limit").getAttribute("d")')

    def set_number(self, label, value):
        self.browser.evaluate(f"""(() => {{
            const input = document.querySelector('input[type="number"][aria-label="{label}"]');
            input.value = {json.dumps(str(value))};
            input.dispatchEvent(new Event("input"));
        }})()""")

    def set_ends(self, ends):
        self.browser.evaluate(f"""(() => {{
            const select = document.querySelector('select[aria-label="ends"]');
            select.value = "{ends}";
            select.dispatchEvent(new Event("change"));
        }})()""")

    def text(self, selector):
        return self.browser.evaluate(f'document.querySelector({json.dumps(selector)}).textContent')

    def click(self, x, y, times=1):
        for clicks in range(1, times + 1):
            self.browser.mouse("mousePressed", x, y, clickCount=clicks)
            self.browser.mouse("mouseReleased", x, y, clickCount=clicks)

    def check_formulas(self):
        boxes = self.browser.evaluate("""(() => {
            document.querySelectorAll("details").forEach((d) => { d.open = true; });
            return [...document.querySelectorAll("math")].map((m) => {
                const b = m.getBoundingClientRect();
                return [b.width, b.height, m.querySelectorAll("merror").length];
            });
        })()""")
        self.assertGreater(len(boxes), 10)
        for width, height, errors in boxes:
            self.assertGreater(width, 2)
            self.assertGreater(height, 5)
            self.assertEqual(errors, 0)
        # A fraction is higher than a number beside it: it is typeset, not written one after the other.
        self.assertTrue(self.browser.evaluate("""[...document.querySelectorAll("mfrac")].every((f) =>
            f.getBoundingClientRect().height > 1.3 * f.children[0].getBoundingClientRect().height)"""))

    def check_images(self):
        self.assertTrue(self.browser.evaluate(
            '[...document.images].every((i) => i.complete && i.naturalWidth > 100 && i.alt !== "")'))

    def test_scheme(self):
        self.open("tension4")
        self.assertEqual(self.browser.complaints(), [])
        self.check_formulas()
        self.check_images()
        # A button copies a block of text, commands without their prompts.
        self.browser.evaluate("navigator.clipboard.writeText = async (text) => { window.copied = text; }")
        self.browser.evaluate("""[...document.querySelectorAll("#masks .copied")].filter((c) => c.querySelector(".prompt"))[0]
            .querySelector("button").click()""")
        self.assertEqual(self.browser.evaluate("window.copied"), "twoscale table tension4 --v0=2 --levels 6\n")
        self.assertIn("k,index,value", self.browser.evaluate('document.querySelector("#masks").textContent'))
        # Every control changes the curve.
        start = self.curve()
        self.assertGreater(start.count("L"), 100)
        before = start
        for label, value in (("v0", 50), ("levels", 3), ("v0", -0.5)):
            self.set_number(label, value)
            after = self.curve()
            self.assertNotEqual(after, before, label)
            before = after
        self.set_number("v0", -1.5)
        self.assertEqual(self.curve(), "")
        self.browser.evaluate("""[...document.querySelectorAll("button")].find((b) => b.textContent === "reset").click()""")
        self.assertEqual(self.curve(), start)
        # The slider does what the number does.
        self.browser.evaluate("""(() => {
            const input = document.querySelector('input[type="range"][aria-label="v0"]');
            input.value = 0.9;
            input.dispatchEvent(new Event("input"));
        })()""")
        self.assertNotEqual(self.curve(), start)
        self.assertNotEqual(self.browser.evaluate(
            """document.querySelector('input[type="number"][aria-label="v0"]').value"""), "2")
        self.assertEqual(self.browser.complaints(), [])

    def test_mouse_and_keyboard(self):
        self.open("dd:l=2")
        self.browser.evaluate('document.querySelector(".interactive").scrollIntoView()')
        handles = '[...document.querySelectorAll(".handle")]'
        count = self.browser.evaluate(f"{handles}.length")
        box = self.browser.evaluate(f"(({handles})[0].getBoundingClientRect()).toJSON()")
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        start = self.curve()
        self.browser.mouse("mousePressed", x, y, clickCount=1)
        self.browser.mouse("mouseMoved", x + 40, y + 25, buttons=1)
        self.browser.mouse("mouseReleased", x + 40, y + 25, clickCount=1)
        dragged = self.curve()
        self.assertNotEqual(dragged, start)
        moved = self.browser.evaluate(f"(({handles})[0].getBoundingClientRect()).toJSON()")
        self.assertAlmostEqual(moved["x"] - box["x"], 40, delta=1)
        self.assertAlmostEqual(moved["y"] - box["y"], 25, delta=1)
        # The curve interpolates the point where it was dropped: its path begins there.
        first = self.browser.evaluate(f'({handles})[0].getAttribute("cx") + " " + ({handles})[0].getAttribute("cy")')
        self.assertTrue(dragged.startswith("M" + first))
        for kind in ("keyDown", "keyUp"):
            self.browser.call("Input.dispatchKeyEvent", type=kind, key="ArrowLeft", code="ArrowLeft", windowsVirtualKeyCode=37)
        self.assertNotEqual(self.curve(), dragged)
        # A double click on a point removes it, one elsewhere adds one.
        self.click(moved["x"] + moved["width"] / 2 - 5, moved["y"] + moved["height"] / 2, times=2)
        self.assertEqual(self.browser.evaluate(f"{handles}.length"), count - 1)
        svg = self.browser.evaluate('document.querySelector(".interactive svg").getBoundingClientRect().toJSON()')
        self.click(svg["x"] + 20, svg["y"] + 20, times=2)
        self.assertEqual(self.browser.evaluate(f"{handles}.length"), count)
        self.assertEqual(self.browser.complaints(), [])

    def test_edge_parameters(self):
        self.open("nuli4")
        start = self.curve()
        self.set_number("lambda of the marked edge", 0.9)
        marked = self.curve()
        self.assertNotEqual(marked, start)
        # Another edge is marked by a click, and has a value of its own.
        self.browser.evaluate('document.querySelector(".interactive").scrollIntoView()')
        box = self.browser.evaluate('document.querySelectorAll(".handle")[3].getBoundingClientRect().toJSON()')
        self.click(box["x"] + 5, box["y"] - 12)
        value = 'document.querySelector(\'input[type="number"][aria-label^="lambda"]\').value'
        self.assertEqual(self.browser.evaluate(value), "0.5")
        self.set_number("lambda of the marked edge", 0.1)
        self.assertNotEqual(self.curve(), marked)
        self.assertEqual(self.browser.complaints(), [])

    def test_open_polygon(self):
        self.open("dd:l=2")
        self.browser.evaluate('document.querySelector(".interactive").scrollIntoView()')
        handles = 'document.querySelectorAll(".handle")'
        crown = 'document.querySelector(".interactive .crown").getAttribute("d")'
        start = self.curve()
        count = self.browser.evaluate(f"{handles}.length")
        self.assertTrue(start.endswith("Z"))
        self.set_ends("linear")
        opened = self.curve()
        self.assertFalse(opened.endswith("Z"))
        self.assertFalse(self.browser.evaluate(crown).endswith("Z"))
        self.assertEqual(self.text(".interactive .message").split(".")[0],
                         f"{count} points become {opened.count('L') + 1}")
        self.assertIn("--open linear --levels", self.text(".controls code"))
        # It runs from the first point to the last one.
        first, last = (self.browser.evaluate(f'[..."xy"].map((c) => {handles}[{i}].getAttribute("c" + c)).join(" ")')
                       for i in (0, count - 1))
        self.assertTrue(opened.startswith("M" + first), first)
        self.assertTrue(opened.endswith("L" + last), last)
        # Points beyond the ends are part of the polygon, and shown so; the curve ends between them.
        self.set_ends("given")
        self.assertEqual(self.browser.evaluate(f'[...{handles}].map((h) => Number(h.classList.contains("beyond"))).join("")'),
                         "1100011")
        given = self.curve()
        self.assertLess(given.count("L"), opened.count("L"))
        # A point moves the curve; a double click beyond an end adds one there.
        self.set_ends("linear")
        box = self.browser.evaluate(f"{handles}[{count - 1}].getBoundingClientRect().toJSON()")
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        self.browser.mouse("mousePressed", x, y, clickCount=1)
        self.browser.mouse("mouseMoved", x - 10, y, buttons=1)
        self.browser.mouse("mouseReleased", x - 10, y, clickCount=1)
        dragged = self.curve()
        self.assertNotEqual(dragged, opened)
        self.click(x - 40, y + 5, times=2)
        self.assertEqual(self.browser.evaluate(f"{handles}.length"), count + 1)
        longer = self.curve()
        self.assertGreater(longer.count("L"), dragged.count("L"))
        self.assertAlmostEqual(self.browser.evaluate(f"{handles}[{count}].getBoundingClientRect().x") + box["width"] / 2,
                               x - 40, delta=1)
        self.browser.evaluate("""[...document.querySelectorAll("button")].find((b) => b.textContent === "reset").click()""")
        self.assertEqual(self.curve(), start)
        self.assertEqual(self.browser.complaints(), [])

    def test_ends_that_need_more_points(self):
        self.open("dd:l=3")
        self.set_ends("given")
        self.assertEqual(self.curve(), "")
        self.assertIn("need more than 7 points", self.text(".interactive .message"))

    def test_open_edge_parameters(self):
        self.open("nuli4")
        start = self.curve()
        self.browser.evaluate('document.querySelector(".interactive").scrollIntoView()')
        # The closing edge is marked, and goes; another one is marked then.
        first, last = (self.browser.evaluate(f'document.querySelectorAll(".handle")[{i}].getBoundingClientRect().toJSON()')
                       for i in (0, 6))
        self.click((first["x"] + last["x"] + first["width"]) / 2, (first["y"] + last["y"] + first["height"]) / 2)
        chosen = 'document.querySelector(".interactive .chosen").getAttribute("d")'
        closing = self.browser.evaluate(chosen)
        self.set_ends("linear")
        self.assertNotEqual(self.browser.evaluate(chosen), closing)
        opened = self.curve()
        self.assertNotEqual(opened, start)
        self.set_number("lambda of the marked edge", 0.9)
        self.assertNotEqual(self.curve(), opened)
        self.assertEqual(self.browser.complaints(), [])

    def test_paper(self):
        self.open("beccari2007")
        self.assertEqual(self.browser.complaints(), [])
        self.assertEqual(self.browser.evaluate("""(() => {
            const ids = [...document.querySelectorAll("[id]")].map((e) => e.id);
            return ids.filter((id, i) => ids.indexOf(id) !== i);
        })()"""), [])
        self.assertEqual(self.browser.evaluate('document.querySelectorAll("article > .interactive .limit").length'), 1)
        self.check_formulas()
        self.check_images()

    def test_a_broken_page_is_seen(self):
        self.open("bspline:n=3")
        path = self.path("page/index.html")
        with open(path, encoding="utf-8") as file:
            page = file.read()
        self.path("broken.html", page.replace("curve_mask(", "curve_task(", 1))
        self.browser.open(self.path("broken.html"))
        self.assertNotEqual(self.browser.complaints(), [])


if __name__ == "__main__":
    unittest.main()
