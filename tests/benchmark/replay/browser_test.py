# SPDX-License-Identifier: MIT
"""Opens a replay in Chromium and uses it: browser_test.py PATH_OF_bulletnav.

Needs Debian's chromium and chromium-driver; leaves with 77 (skipped) where they are missing.
"""
import json
import pathlib
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import urllib.request

CONFIG = """
houses: {folder: houses, count: 1, first_seed: 3}
episodes:
  file: episodes.json
  draw: {houses: {index: houses/index.json, split: train}, counts: {easy: 2, hard: 1}, seed: 1}
backend: embree
settings: [rgbd]
max_steps: 60
agents: [{agent: nts}, {agent: metric_map_fbe}]
"""


class Browser:
    """A window, by the WebDriver protocol."""

    def __init__(self, *flags):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.port = free.getsockname()[1]
        self.driver = subprocess.Popen(["chromedriver", f"--port={self.port}"],
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        options = {"args": ["--headless", "--no-sandbox", "--window-size=1400,900",
                            "--disable-dev-shm-usage", *flags]}
        wanted = {"capabilities": {"alwaysMatch": {
            "browserName": "chrome", "goog:chromeOptions": options,
            "goog:loggingPrefs": {"browser": "ALL"}}}}
        for _ in range(100):
            try:
                self.session = ""
                self.session = "/" + self.call("POST", "", wanted)["sessionId"]
                return
            except ConnectionError:
                time.sleep(0.1)
            except urllib.error.URLError:
                time.sleep(0.1)
        raise SystemExit("chromedriver does not answer")

    def call(self, method, path, data=None):
        request = urllib.request.Request(
            f"http://127.0.0.1:{self.port}/session{self.session}{path}", method=method,
            data=None if data is None else json.dumps(data).encode())
        with urllib.request.urlopen(request, timeout=120) as answer:
            return json.load(answer)["value"]

    def open(self, url):
        self.call("POST", "/url", {"url": url})

    def run(self, script):
        return self.call("POST", "/execute/sync", {"script": script, "args": []})

    def wait(self, script, wanted=True):
        for _ in range(100):
            value = self.run("return " + script)
            if value == wanted:
                return
            time.sleep(0.1)
        raise AssertionError(f"{script} is {value!r}, not {wanted!r}")

    def press(self, key):
        self.run(f"document.dispatchEvent(new KeyboardEvent('keydown', {{key: {json.dumps(key)}}}))")

    def complaints(self):
        return [entry["message"] for entry in self.call("POST", "/se/log", {"type": "browser"})
                if entry["level"] == "SEVERE"]

    def close(self):
        try:
            self.call("DELETE", "")
        finally:
            self.driver.terminate()
            self.driver.wait()


def colours_of(canvas):
    """How many colours a canvas shows, up to 50."""
    return ("(() => { const c = byId('%s'); const d = c.getContext('2d').getImageData(0, 0, c.width,"
            " c.height).data; const s = new Set(); for (let i = 0; i < d.length && s.size < 50;"
            " i += 4) s.add(d[i] + 256 * d[i + 1] + 65536 * d[i + 2]); return s.size; })()" % canvas)


def check_list(browser):
    browser.wait("run.rows.length", 6)
    browser.wait("document.querySelectorAll('.row').length", 3)  # of the first agent
    browser.run("document.querySelectorAll('#agents button')[0].click()")
    browser.wait("document.querySelectorAll('.row').length", 6)
    browser.run("byId('other').value = 1; byId('other').onchange()")
    browser.run("document.querySelectorAll('#agents button')[1].click()")
    browser.wait("document.querySelectorAll('.row').length", 3)
    browser.run("document.querySelectorAll('.row')[1].click()")
    browser.wait("now.one !== null && now.two !== null && now.one.row === now.row")
    assert browser.run("return byId('verdict').children.length") == 2


def check_player(browser):
    browser.wait(colours_of("plan"), 50)
    browser.wait(colours_of("sees"), 50)
    browser.wait(colours_of("goal"), 50)
    last = browser.run("return now.step")
    assert last > 3
    browser.press("Home")
    browser.wait("now.step", 0)
    browser.press("ArrowRight")
    browser.wait("now.step", 1)
    browser.wait("now.one.beliefs === null || now.one.beliefs.done >= 1")
    browser.press(" ")
    browser.wait("now.step > 2")
    browser.press(" ")
    browser.press("End")
    browser.wait("now.step", last)
    before = browser.run("return byId('plan').toDataURL()")
    browser.press("b")
    browser.wait("layers.beliefs", False)
    browser.wait(f"byId('plan').toDataURL() !== {json.dumps(before)}")
    browser.press("b")


def check_link(browser, page):
    browser.press("Home")
    browser.press("ArrowRight")
    link = browser.run("return location.hash")
    chosen = browser.run("return [now.row.number, filter.other]")
    browser.open("about:blank")
    browser.open(page + link)
    browser.wait("now.one !== null && [now.row.number, filter.other].join()",
                 ",".join(map(str, chosen)))
    browser.wait("now.step", 1)


def check_rest(browser):
    browser.press("c")
    browser.wait("document.querySelectorAll('#charts svg').length >= 4")
    browser.press("c")
    theme = browser.run("return document.documentElement.dataset.theme")
    browser.press("t")
    browser.wait(f"document.documentElement.dataset.theme !== '{theme}'")


def check_solid(browser, has_webgl):
    browser.press("3")
    browser.wait("now.solid", has_webgl)
    browser.wait("byId('notes').textContent.includes('no WebGL')", not has_webgl)
    browser.wait("byId('plan').hidden", has_webgl)
    if has_webgl:
        browser.wait("solid.mesh !== undefined && solid.mesh.length > 1000")
        browser.wait("solid.gl.getError()", 0)


def main():
    if not shutil.which("chromedriver") or not shutil.which("chromium"):
        print("skipped: no chromium and chromium-driver here")
        sys.exit(77)
    program = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        (work / "run.yaml").write_text(CONFIG)
        for command in (["run", "run.yaml", "--no-plots", "--beliefs", "--out", "results"],
                        ["replay", "results"]):
            subprocess.run([program, *command], cwd=work, check=True, stdout=subprocess.DEVNULL,
                           stderr=subprocess.DEVNULL)
        page = (work / "results" / "replay.html").as_uri()
        webgl = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
        for flags, has_webgl in ((webgl, True), (["--disable-3d-apis"], False)):
            browser = Browser(*flags)
            try:
                browser.open(page)
                check_list(browser)
                if has_webgl:
                    check_player(browser)
                    check_link(browser, page)
                    check_rest(browser)
                check_solid(browser, has_webgl)
                assert not browser.complaints(), browser.complaints()
            finally:
                browser.close()
    print("passed")


main()
