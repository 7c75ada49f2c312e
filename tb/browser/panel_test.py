#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The pages of `stream --web` and `board --web` in a real browser, while a virtual board draws:
they show what it says, buttons are obeyed, and who has no token, or comes from elsewhere, is not.

    panel_test.py --program build/curvecore [--pictures FOLDER]
"""

import pathlib
import re
import signal
import socket
import subprocess
import tempfile
import unittest

from chromium import OPTIONS, Chromium, run_tests

STEPS_PER_MM = 400
FEED = 600  # mm/min
WAY = 100  # mm of a move
# Some minutes of the board's time: it ends when it is told to.
PART = "G64 P0.01\n" + "".join(
    f"G1 X{WAY * (n % 2 == 0)} Y{n} F{FEED}\n" for n in range(20)) + "M2\n"


def upgrade(host, *headers):
    """Asks for a web socket; returns the connection and the status of the answer."""
    link = socket.create_connection(("127.0.0.1", int(host.split(":")[1])))
    lines = ["GET /live HTTP/1.1", f"Host: {host}", "Upgrade: websocket", "Connection: Upgrade",
             "Sec-WebSocket-Key: MDEyMzQ1Njc4OWFiY2RlZg==", "Sec-WebSocket-Version: 13", *headers]
    link.sendall("\r\n".join([*lines, "", ""]).encode("ascii"))
    return link, link.recv(12).decode("ascii")[9:]


class Panel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.browser = Chromium()

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        self.elsewhere = self.folder / "elsewhere.html"
        self.elsewhere.write_text("<title>elsewhere</title>", encoding="ascii")
        part = self.folder / "part.ngc"
        part.write_text(PART, encoding="ascii")
        self.board = self.start("board", "--build", "parallel", "--listen", "127.0.0.1:0",
                                "--web", "0", "-o", self.folder / "board")
        port = re.search(r":(\d+):", self.board.stdout.readline())[1]
        self.board_page = self.board.stdout.readline().split()[1]
        self.host = self.start("stream", part, "--to", f"udp:127.0.0.1:{port}", "--web", "0", "-q")
        self.page = self.host.stdout.readline().split()[1]
        self.browser.send("Emulation.setDeviceMetricsOverride", width=1280, height=900,
                          deviceScaleFactor=1, mobile=False)
        self.visit(self.page)

    def visit(self, page):
        self.browser.open(self.elsewhere)  # a new # alone loads nothing
        self.browser.open(page)

    def start(self, *arguments):
        process = subprocess.Popen([OPTIONS.program, *map(str, arguments)],
                                   stdout=subprocess.PIPE, text=True)

        def end():
            process.kill()
            process.wait()
            process.stdout.close()

        self.addCleanup(end)
        return process

    def tearDown(self):
        self.assertEqual(self.browser.errors(), [])

    def until(self, expression):
        """Waits for a condition of the page; ctest ends what never is."""
        return self.browser.get(f"""new Promise((done) => {{
            const look = () => {{
                const value = {expression};
                if (value) done(value); else setTimeout(look, 20);
            }};
            look();
        }})""")

    def press(self, wish):
        self.until(f"!document.querySelector('[data-wish={wish}]').disabled")
        self.click(f"[data-wish={wish}]")

    def click(self, what):
        x, y = self.browser.middle(what)
        for kind in ("mousePressed", "mouseReleased"):
            self.browser.send("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left",
                              clickCount=1)

    def shown(self):
        return self.browser.get("status")

    def runs(self):
        self.until('status && status.state === "runs" && status.path_mm > 1')

    def test_shows_the_machine_and_obeys_its_buttons(self):
        self.runs()
        seen = self.shown()
        self.assertEqual([axis["name"] for axis in seen["axes"]], ["X", "Y", "Z"])
        self.assertEqual(seen["override_percent"], 100)
        self.press("hold")
        held = self.until('status.state === "held" && status')
        self.assertEqual(held["rate_percent"], 0)
        # The place of the axes is that of the path, of steps that are made.
        place, path = held["axes"][0]["place_mm"], held["path_mm"]
        self.assertLess(held["line"], 4, held)
        if path < WAY - 1:
            self.assertAlmostEqual(place, path, delta=0.05)
        self.until(f"points.length > 20 && points[points.length - 1][3] > {20 * WAY - 1}")
        self.picture("held")
        self.press("resume")
        self.until(f'status.state === "runs" && status.path_mm > {path + 1}')
        self.browser.get('byId("rate").value = 50; byId("rate").oninput()')
        self.until('status.override_percent === 50 && Math.abs(status.rate_percent - 50) < 0.1')
        self.assertIn("override 50 %", self.until('byId("log").textContent'))
        self.press("stop")
        self.assertEqual(self.host.wait(), 130)
        self.until('!open && byId("state").textContent === "stopped"')
        self.assertRegex(self.browser.get('byId("options").textContent'), r"^--from \d+\.\d{6}mm$")
        self.assertTrue(self.browser.get('document.querySelector("[data-wish=hold]").disabled'))
        self.board.send_signal(signal.SIGINT)
        self.board.wait()
        rows = (self.folder / "board" / "steps.csv").read_text(encoding="ascii").split()[1:]
        x = sum(int(row.split(",")[2]) for row in rows if row.split(",")[1] == "0") / STEPS_PER_MM
        shown = self.shown()["axes"][0]["place_mm"]
        self.assertAlmostEqual(x, shown, delta=0.5 / STEPS_PER_MM)

    def test_a_board_shows_where_its_axes_are(self):
        self.runs()
        self.visit(self.board_page)
        self.until('status && status.state === "runs" && points.length > 20')
        self.assertNotIn("#", self.board_page, "nobody asks a board for anything")
        self.assertFalse(self.browser.get(
            '[...document.querySelectorAll("button, #rate")].some((e) => e.offsetParent)'))
        self.assertEqual(self.browser.get('byId("dro").textContent.match(/[A-Z]/g).join("")'),
                         "XYZ")
        # Points of the way follow it, and none is off it.
        way = self.until(f"status.way_steps > {3 * STEPS_PER_MM} && status.way_steps")
        self.until(f"points[points.length - 1][3] >= {way}")
        x, y, z, path, _ = self.browser.get("points[points.length - 1]")
        self.assertAlmostEqual(abs(x), path, delta=0.02 * path)
        self.assertEqual((y, z), (0, 0))
        self.picture("board")
        self.host.send_signal(signal.SIGINT)
        self.until('status.state === "drives off"')
        self.assertIn("drives off", self.until('byId("log").textContent'))
        seen = [axis["steps"] for axis in self.shown()["axes"]]
        self.board.send_signal(signal.SIGINT)
        self.board.wait()
        rows = (self.folder / "board" / "steps.csv").read_text(encoding="ascii").split()[1:]
        counted = [sum(int(row.split(",")[2]) for row in rows if row.split(",")[1] == str(axis))
                   for axis in range(3)]
        self.assertEqual(seen, counted)

    def test_turns_the_drives_off(self):
        self.runs()
        self.press("estop")
        self.assertEqual(self.host.wait(), 1)
        self.until('status.state === "fault" && status.faults !== ""')

    def test_gives_what_draws_the_rest_on_a_board_that_is_lost(self):
        self.runs()
        self.assertTrue(self.browser.get('byId("rest").hidden'))
        self.board.kill()
        self.assertEqual(self.host.wait(), 1)
        self.until('status.state === "lost" && !byId("rest").hidden')
        self.browser.get(
            "navigator.clipboard.writeText = async (text) => { window.copied = text; }; 0")
        self.click("#copy")
        self.assertEqual(self.until("window.copied"), "--rest")
        self.assertEqual(self.browser.get("getSelection().toString()"), "--rest")
        self.picture("lost")

    def test_fits_a_phone(self):
        self.browser.send("Emulation.setDeviceMetricsOverride", width=390, height=844,
                          deviceScaleFactor=1, mobile=True)
        self.visit(self.page)
        self.runs()
        self.until("points.length > 20")
        self.assertEqual(self.browser.get("innerWidth"), 390)
        self.assertEqual(self.browser.wider_than(390), [])
        self.picture("phone")

    def test_who_has_no_token_may_look(self):
        address = self.page.split("#")[0]
        for page in (address, address + "#" + "0" * 32):
            with self.subTest(page=page):
                self.visit(page)
                self.runs()
                self.assertTrue(self.browser.get('document.querySelector("#estop").disabled'))
                # Neither through the page's own scripts.
                self.browser.get('control = true; ask("hold"); ask("override 10"); 0')
                path = self.shown()["path_mm"]
                seen = self.until(f"status.path_mm > {path + 5} && status")
                self.assertEqual((seen["state"], seen["override_percent"]), ("runs", 100))

    def test_other_pages_and_names_are_refused(self):
        host = self.page.split("/")[2]
        self.runs()
        for headers, status in ([[], "101"], [[f"Origin: http://{host}"], "101"],
                                [["Origin: http://elsewhere.example"], "403"],
                                [["Origin: null"], "403"]):
            with self.subTest(headers=headers):
                link, answer = upgrade(host, *headers)
                link.close()
                self.assertEqual(answer, status)
        for request, answer in {
                f"GET / HTTP/1.1\r\nHost: elsewhere.example:{host.split(':')[1]}\r\n\r\n": b" 403 ",
                f"POST / HTTP/1.1\r\nHost: {host}\r\n\r\n": b" 405 ",
                f"GET /etc/passwd HTTP/1.1\r\nHost: {host}\r\n\r\n": b" 404 ",
                f"GET / HTTP/1.1\r\nHost: {host}\r\n\r\n": b" 200 "}.items():
            with self.subTest(request=request):
                with socket.create_connection(("127.0.0.1", int(host.split(":")[1]))) as link:
                    link.sendall(request.encode("ascii"))
                    self.assertIn(answer, link.recv(100))

    def test_a_flood_stops_nothing(self):
        self.runs()
        path = self.shown()["path_mm"]
        # Of a hundred connections the oldest make room, but not the one that has the token.
        self.browser.get("lost = 0; socket.addEventListener('close', () => { lost = 1; }); 0")
        links = [upgrade(self.page.split("/")[2]) for _ in range(100)]
        self.assertEqual({status for _, status in links}, {"101"})
        self.until(f"status.path_mm > {path + 1}")
        self.assertEqual(self.browser.get("lost"), 0)
        for link, _ in links:
            link.close()
        self.until("control")
        # Two storms at once, and messages that are none.
        self.browser.get("""for (let n = 0; n < 10000; ++n) {
            ask("override " + (1 + n % 100));
            say(n % 3 ? { wish: ["hold"] } : [n]);
        } 0""")
        self.browser.get('ask("override 70"); 0')
        self.until(f"status.override_percent === 70 && status.path_mm > {path + 5}")
        self.browser.get('socket.send("x".repeat(300)); 0')  # ends this connection, and no other
        self.until("!open")
        self.until('open && status.state === "runs"')
        self.press("stop")
        self.assertEqual(self.host.wait(), 130)

    def picture(self, name):
        if OPTIONS.pictures:
            self.browser.picture(OPTIONS.pictures / f"panel_{name}.png", captureBeyondViewport=True)


if __name__ == "__main__":
    run_tests(__doc__.split("\n")[0])
