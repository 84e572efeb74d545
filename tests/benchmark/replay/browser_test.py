# SPDX-License-Identifier: MIT
"""The page in a browser: Debian's Chromium, by its driver, without network."""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.request

import support

if not (shutil.which("chromium") and shutil.which("chromedriver")):
    sys.stderr.write("skipped: there is no Chromium; apt-get install chromium chromium-driver\n")
    sys.exit(77)
SOFTWARE_GL = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
NO_GL = ["--disable-gpu", "--disable-3d-apis"]


class Browser:
    """One window. Source: W3C WebDriver."""

    def __init__(self, folder, more):
        self.driver = subprocess.Popen(["chromedriver", "--port=0"], stdout=subprocess.PIPE,
                                       stderr=subprocess.DEVNULL, text=True)
        for line in self.driver.stdout:
            if "started successfully on port" in line:
                self.port = int(line.split("port")[1].strip(" .\n"))
                break
        arguments = ["--headless=new", "--no-sandbox", "--window-size=1400,900",
                     "--disable-dev-shm-usage", f"--user-data-dir={folder}", *more]
        options = {"browserName": "chrome", "goog:chromeOptions": {"args": arguments},
                   "goog:loggingPrefs": {"browser": "ALL"}}
        self.session = ""
        answer = self.ask("", {"capabilities": {"alwaysMatch": options}})
        self.session = "/" + answer["sessionId"]

    def ask(self, path, body=None):
        """Posts `body`, and returns the answer's value."""
        request = urllib.request.Request(
            f"http://127.0.0.1:{self.port}/session{self.session}{path}",
            data=json.dumps(body or {}).encode(), headers={"Content-Type": "application/json"})
        return json.load(urllib.request.urlopen(request, timeout=60))["value"]

    def js(self, script):
        """Value of an expression; waits for promises."""
        return self.ask("/execute/sync", {"script": f"return {script}", "args": []})

    def open(self, address):
        """Opens a page and waits until it shows something."""
        self.ask("/url", {"url": "about:blank"})
        self.ask("/url", {"url": address})
        for _ in range(200):
            if self.js("document.documentElement.dataset.ready") == "yes":
                return
            time.sleep(0.05)
        raise AssertionError(f"the page is not ready; {self.complaints()}")

    def complaints(self):
        """What went wrong, as the browser says."""
        return [one["message"] for one in self.ask("/se/log", {"type": "browser"})
                if one["level"] == "SEVERE" and "favicon" not in one["message"]]

    def press(self, key, event="keydown"):
        self.js(f"document.dispatchEvent(new KeyboardEvent('{event}', {{key: {key!r}}}))")
        time.sleep(0.15)

    def close(self):
        self.driver.terminate()
        self.driver.stdout.close()
        self.driver.wait()


class Replay(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        run = support.play(cls.folder, "run", "--beliefs")
        done, _ = support.replay(run)
        assert done.returncode == 0, done.stderr
        cls.page = (run / "replay.html").as_uri()
        cls.varied = cls.page_of_two_settings(run).as_uri()
        cls.browser = cls.window(SOFTWARE_GL)

    @classmethod
    def page_of_two_settings(cls, run):
        """Of results by another version, those of rgb without paths, and with a damaged line."""
        other = pathlib.Path(shutil.copytree(run, cls.folder / "varied"))
        lines = (other / "episodes.jsonl").read_text()
        more = lines.replace('"setting":"rgbd"', '"setting":"rgb"') + "x" * 300 + "{\n"
        (other / "episodes.jsonl").write_text(lines + more)
        (other / "versions.txt").write_text("0.0.9 (abc)\n")
        done, _ = support.replay(other, "--panoramas", "0")
        assert done.returncode == 0, done.stderr
        return other / "replay.html"

    @classmethod
    def window(cls, more):
        browser = Browser(tempfile.mkdtemp(dir=cls.folder), more)
        cls.addClassCleanup(browser.close)
        return browser

    def setUp(self):
        self.browser.open(self.page)
        self.addCleanup(lambda: self.assertEqual(self.browser.complaints(), []))

    def js(self, script):
        return self.browser.js(script)

    def until(self, script):
        """Waits until an expression is true: a busy machine takes its time."""
        for _ in range(100):
            if self.js(script):
                return
            time.sleep(0.05)
        self.fail(f"still not so: {script}")

    def until_shown(self):
        """Waits until what is chosen is loaded."""
        self.until("now.results.every(one => one.row === now.row) && location.hash === linkText()")

    def chip(self, text):
        self.js(f"[...document.querySelectorAll('.chips button')].find(b => b.textContent === '{text}').click()")

    def inks(self):
        """How many colours the plan has."""
        return self.js("new Set(new Uint32Array(byId('plan').getContext('2d').getImageData("
                       "0, 0, byId('plan').width, byId('plan').height).data.buffer)).size")

    def test_finds_the_worst_failure_of_an_agent_in_three_clicks(self):
        self.chip("random")
        self.chip("Failed")
        self.js("document.querySelector('#list .row').click()")
        time.sleep(0.3)
        worst = self.js("[now.row.ok, run.agents[now.row.agent][0], now.row.spl]")
        self.assertEqual(worst, [False, "random", 0])
        self.assertGreater(self.inks(), 10)
        self.assertIn("random", self.js("byId('verdict').textContent"))

    def test_filters_and_order(self):
        self.assertEqual(self.js("shown.length"), 4)
        self.chip("All agents")
        self.assertEqual(self.js("shown.length"), 12)
        self.chip("Reached")
        self.assertTrue(self.js("shown.every(row => row.ok)"))
        self.chip("All")
        self.js("(filter.reason = 'stopped short', updateTable(), 0)")
        self.assertTrue(self.js("shown.every(row => row.why === 'stopped short')"))
        self.js("(filter.reason = '', byId('other').value = 2, byId('other').onchange(), 0)")
        self.assertEqual(self.js("shown.map(gainOf).filter(gain => gain > 0).length"), 0)
        self.chip("Metric Spatial Map + FBE + Local")
        gains = self.js("shown.map(gainOf)")
        self.assertEqual(gains, sorted(gains), "by difference of SPL")
        self.js("(byId('gain').value = 'worse', byId('gain').onchange(), 0)")
        self.assertEqual(self.js("shown.length"), sum(gain < 0 for gain in gains))

    def test_plays_beliefs_over_time(self):
        self.js("choose(run.rows.filter(row => row.has_beliefs).sort((a, b) => b.steps - a.steps)[0])")
        time.sleep(0.3)
        known = "now.results[0].beliefs.cells.reduce((n, kind) => n + (kind > 0), 0)"
        first = self.js(known)
        self.assertGreater(first, 0)
        self.browser.press("End")
        self.assertEqual(self.js("now.step"), self.js("now.length"))
        last = self.js(known)
        self.assertGreaterEqual(last, first)
        self.browser.press("Home")
        self.assertEqual([self.js("now.step"), self.js(known)], [0, first], "time runs back too")
        self.browser.press("ArrowRight")
        self.assertEqual(self.js("now.step"), 1)
        self.browser.press(" ")
        self.until("now.step > 2")
        self.browser.press(" ")
        self.assertEqual(self.js("now.playing"), 0)

    def test_plays_from_the_beginning_at_the_end(self):
        self.js("choose(run.rows.filter(row => row.steps > 8).sort((a, b) => a.steps - b.steps)[0])")
        time.sleep(0.3)
        self.browser.press("End")
        self.assertEqual(self.js("(byId('play').click(), now.step)"), 0)
        self.until("now.step > 0")
        self.until("now.step === now.length && !now.playing")

    def test_frames_of_an_earlier_time_do_not_run_back(self):
        self.js("(window.requestAnimationFrame = tick => { window.tick = tick; return 1; }, 0)")
        self.browser.press("End")
        self.browser.press(" ")
        start = self.js("performance.now()")
        steps = [self.js(f"(tick({start + time}), now.step)") for time in (-500, -900, 0, 300)]
        self.assertEqual(steps[:2], [0, 0])
        self.assertGreater(steps[3], 0)

    def chosen(self):
        """Is the row that is shown in the list, in sight and marked? Its agent and episode."""
        self.until_shown()
        marked = self.js("[...document.querySelectorAll('#list .row.on')].map(row => Number(row.dataset.number))")
        self.assertEqual(marked, [self.js("now.row.number")])
        return self.js("[run.agents[now.row.agent][0], now.row.episode]")

    def test_filters_keep_what_is_shown_in_the_list(self):
        self.js("choose(shown[2])")
        episode = self.chosen()[1]
        self.chip("random")
        self.assertEqual(self.chosen(), ["random", episode], "the same episode")
        step = self.js("(goTo(2), now.step)")
        self.chip("All agents")
        self.assertEqual(self.chosen(), ["random", episode], "nothing else is chosen")
        self.assertEqual(self.js("now.step"), step)
        for chip in ("Reached", "Failed"):
            self.chip(chip)
            self.chosen()
        self.chip("shortest_path")
        self.assertEqual(self.js("shown.length"), 0)
        self.assertEqual(self.browser.complaints(), [])
        self.js("choose(run.rows.find(row => run.agents[row.agent][0] === 'random'))")
        time.sleep(0.3)
        self.js("(filter.outcome = 'ok', updateTable(), followLink())")
        self.assertEqual(self.chosen(), ["random", "room-easy-0000"], "a link beats filters")

    def test_rows_tell_settings_apart(self):
        self.assertEqual(self.js("document.querySelectorAll('#list .variant').length"), 0, "one setting")
        self.browser.open(self.varied)
        texts = self.js("[...document.querySelectorAll('#list .row')].map(row => row.children[1].textContent + row.children[2].textContent)")
        self.assertEqual(len(set(texts)), 8, texts)
        self.assertEqual(self.js("unique([...document.querySelectorAll('#list .variant')].map(one => one.textContent)).sort()"), ["rgb", "rgbd"])
        self.assertTrue(self.js("[...document.querySelectorAll('#list .variant')].every(one => one.scrollWidth <= one.clientWidth)"))
        ends = "[...document.querySelectorAll('%s span')].map(one => Math.round(one.getBoundingClientRect().right))"
        self.assertEqual(self.js(ends % "#list .row:last-child"), self.js(ends % "#columns")[1:])

    def test_nothing_to_play_back(self):
        enabled = "[byId('play').disabled, byId('step').disabled]"
        self.assertEqual(self.js(enabled), [False, False])
        self.browser.open(self.varied)
        self.js("choose(run.rows.find(row => !row.has_path))")
        time.sleep(0.3)
        self.assertEqual(self.js(enabled), [True, True])
        self.browser.press(" ")
        hint = self.js("byId('empty').textContent")
        self.assertIn("--only room-easy", hint)
        self.assertIn("played with bulletnav 0.0.9 (abc)", hint)
        self.js("choose(run.rows.find(row => row.has_path))")
        time.sleep(0.3)
        self.assertEqual(self.js(enabled), [False, False])

    def test_notes_stay_in_their_box(self):
        self.browser.open(self.varied)
        self.assertIn("episodes.jsonl:25", self.js("byId('notes').textContent"))
        self.assertTrue(self.js("byId('notes').scrollWidth <= byId('notes').clientWidth"))
        self.js("(byId('notes').append('a/'.repeat(900)), 0)")
        self.assertTrue(self.js("byId('notes').scrollWidth <= byId('notes').clientWidth"))
        self.assertTrue(self.js("document.body.scrollHeight <= innerHeight && document.body.scrollWidth <= innerWidth"))

    def test_the_plan_has_its_shape_at_once(self):
        self.js("(window.onresize = null, 0)")
        for step in ("run.rows[0]", "run.rows[8]"):
            self.js(f"choose({step})")
            time.sleep(0.3)
            self.assertEqual(self.js("[byId('plan').width, byId('plan').height]"),
                             self.js("[byId('plan').clientWidth, byId('plan').clientHeight]"))

    def test_links_lead_back(self):
        self.js("choose(run.rows[7], 3)")
        time.sleep(0.3)
        link = self.js("location.href")
        self.browser.open(link)
        self.assertEqual(self.js("[now.row.number, now.step]"), [7, 3])
        self.browser.open(self.page + "#agent=random&episode=none")
        self.assertIn("no result", self.js("byId('message').textContent"))
        low = self.js("byId('message').getBoundingClientRect().bottom")
        self.assertLessEqual(low, self.js("byId('stage').getBoundingClientRect().top"), "not over the plan")
        self.js("choose(shown[1])")
        self.assertEqual(self.js("byId('message').textContent"), "")
        self.browser.open(link.replace("step=3", "step=1.5"))
        self.assertEqual(self.js("now.step"), 1)

    def test_charts_and_themes(self):
        self.browser.press("c")
        self.assertGreaterEqual(self.js("document.querySelectorAll('#charts svg').length"), 3)
        before = self.js("getComputedStyle(document.body).backgroundColor")
        self.browser.press("t")
        self.assertNotEqual(self.js("getComputedStyle(document.body).backgroundColor"), before)

    def test_house_in_3d(self):
        self.browser.press("3")
        self.assertTrue(self.js("now.solid"))
        inks = self.js("(() => { const gl = solid.gl, out = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);"
                       "gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, out);"
                       "return [new Set(new Uint32Array(out.buffer)).size, gl.getError()]; })()")
        self.assertGreater(inks[0], 4)
        self.assertEqual(inks[1], 0)
        self.browser.press("3")
        self.assertFalse(self.js("now.solid"))

    def test_without_webgl_says_so_and_keeps_the_plan(self):
        plain = self.window(NO_GL)
        plain.open(self.page)
        plain.press("3")
        self.assertEqual(plain.js("[now.solid, byId('no_webgl').hidden, byId('plan').hidden]"), [False, False, False])
        self.assertIn("no WebGL", plain.js("byId('no_webgl').textContent"))

    def test_three_thousand_results_stay_quick(self):
        taken = self.js("(() => { const many = []; for (let i = 0; i < 3000; ++i) many.push({...run.rows[i % 12], number: i});"
                        "run.rows = many; filter.agent = -1; const begin = performance.now(); updateTable();"
                        "return [performance.now() - begin, shown.length, document.querySelectorAll('#list .row').length]; })()")
        self.assertEqual(taken[1], 3000)
        self.assertLess(taken[2], 60, "only rows in sight are made")
        self.assertLess(taken[0], 1000)


if __name__ == "__main__":
    unittest.main()
