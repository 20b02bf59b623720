# SPDX-License-Identifier: MIT
"""Controls a page in headless Chromium with Selenium and chromedriver.

A test file is a Python program that ends in `browser.main()`. Each test is a `browser.Case`: it opens pages, presses
keys and reads the page. At the end of each test the console must contain no error, and no request may have been sent to
another machine. Without Chromium the program prints a message and exits with 77, which means that the test is skipped.
"""
import base64
import contextlib
import functools
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import urllib.parse
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer

try:
    from selenium import webdriver
    from selenium.common.exceptions import StaleElementReferenceException
    from selenium.webdriver.chrome.options import Options
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
except ImportError:
    webdriver = By = Keys = None
    StaleElementReferenceException = AssertionError

SKIPPED = 77
SOURCE = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("GRAFVERIF_PROGRAM", str(SOURCE / "build/dev/bin/grafverif"))
SIZES = {"laptop": (1366, 768), "tablet": (820, 1180), "phone": (390, 844)}
SCHEMES = ("light", "dark")
SWITCHES = [
    "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-dev-shm-usage",
    "--disable-background-networking", "--disable-component-update", "--disable-sync", "--disable-extensions",
    # Requests to other machines are errors and are blocked.
    "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1, EXCLUDE localhost",
]
# Absolute paths ensure that both programs come from the same package, and exclude wrappers of other packaging systems
# (snap).
CHROMIUM, DRIVER = "/usr/bin/chromium", "/usr/bin/chromedriver"


def why_not():
    """Returns the reason why no browser is available, or an empty string."""
    if webdriver is None:
        return f"{sys.executable} has no Selenium (Debian: python3-selenium)"
    for place, package in ((CHROMIUM, "chromium"), (DRIVER, "chromium-driver")):
        if not os.access(place, os.X_OK):
            return f"there is no {place} (Debian: {package})"
    return ""


def run(*arguments, code=0, folder=None):
    """Returns the output of grafverif, which must exit with `code`; None permits any exit code."""
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, cwd=folder, timeout=60)
    assert code is None or done.returncode == code, f"grafverif {arguments} ends with {done.returncode}: {done.stdout}{done.stderr}"
    return done.stdout


# Maximum time, in seconds, to wait for the page. Only failing tests wait that long, so that the limit also allows for a
# loaded machine.
PATIENCE = 40


def eventually(question, seconds=PATIENCE, what=""):
    """Calls `question` repeatedly and returns its first true result. If the page replaces an element during a call, the
    call is repeated."""
    end = time.monotonic() + seconds
    while True:
        try:
            answer = question()
        except StaleElementReferenceException:
            answer = None
        if answer:
            return answer
        assert time.monotonic() < end, f"not true within {seconds} s: {what or question}"
        time.sleep(0.02)


def leaves_the_machine(address):
    parts = urllib.parse.urlsplit(address)
    if parts.scheme not in ("http", "https", "ws", "wss", "ftp"):
        return False  # file:, data:, blob:, about:, chrome:
    return parts.hostname not in ("127.0.0.1", "::1", "localhost")


@contextlib.contextmanager
def folder_served(folder):
    """Serves the files of `folder` at the yielded address."""
    class Quiet(SimpleHTTPRequestHandler):
        def log_message(self, *_):
            pass

    server = ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=str(folder)))
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    try:
        yield f"http://127.0.0.1:{server.server_port}/"
    finally:
        server.shutdown()
        server.server_close()
        thread.join()


def temporary_folder(case):
    """Creates a temporary folder that is removed after the test."""
    folder = tempfile.mkdtemp(prefix="grafverif-browser-")
    case.addCleanup(shutil.rmtree, folder, ignore_errors=True)
    return pathlib.Path(folder)


class Server:
    """A running `grafverif serve FILE`, or another command that serves a page, with its address."""

    def __init__(self, file, *options, command="serve", **how):
        self.process = subprocess.Popen([PROGRAM, command, str(file), *options], stdout=subprocess.PIPE, text=True, **how)
        line = self.process.stdout.readline()
        self.address = line.split()[-1]
        self.port = urllib.parse.urlsplit(self.address).port
        self.token = urllib.parse.parse_qs(urllib.parse.urlsplit(self.address).query)["token"][0]

    def stop(self):
        self.process.terminate()
        self.process.wait(20)
        self.process.stdout.close()


class Page:
    """A browser window with its console and network events."""

    def __init__(self, driver):
        self.driver = driver

    def open(self, address):
        if isinstance(address, pathlib.Path):
            address = address.resolve().as_uri()
        self.driver.get(address)

    # Contents

    def script(self, text, *arguments):
        return self.driver.execute_script(text, *arguments)

    def find(self, selector):
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def all(self, selector):
        return self.driver.find_elements(By.CSS_SELECTOR, selector)

    def text(self, selector):
        return self.script("const e = document.querySelector(arguments[0]); return e ? e.textContent : null", selector)

    def texts(self, selector):
        return self.script("return [...document.querySelectorAll(arguments[0])].map(e => e.textContent)", selector)

    def wait_for(self, selector, seconds=PATIENCE):
        return eventually(lambda: self.all(selector), seconds, selector)[0]

    def wait_for_text(self, selector, part, seconds=PATIENCE):
        eventually(lambda: part in (self.text(selector) or ""), seconds, f"`{part}` in {selector}")

    def press(self, *keys):
        """Sends keys to the focused element."""
        self.driver.switch_to.active_element.send_keys(*keys)

    # Display

    def size(self, name):
        width, height = SIZES[name]
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": height, "deviceScaleFactor": 1, "mobile": name == "phone"})

    def scheme(self, name):
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {
            "features": [{"name": "prefers-color-scheme", "value": name}]})

    def pdf(self):
        return base64.b64decode(self.driver.execute_cdp_cmd("Page.printToPDF", {"printBackground": True})["data"])

    def screenshot(self, name):
        """Saves a screenshot if GRAFVERIF_SCREENSHOTS names a folder."""
        folder = os.environ.get("GRAFVERIF_SCREENSHOTS")
        if folder:
            self.driver.save_screenshot(str(pathlib.Path(folder) / f"{name}.png"))

    # Events

    def errors(self):
        """Returns the console errors since the last call."""
        return [entry["message"] for entry in self.driver.get_log("browser") if entry["level"] == "SEVERE"]

    def requests(self):
        """Returns the addresses requested since the last call."""
        asked = []
        for entry in self.driver.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                asked.append(message["params"]["request"]["url"])
            elif message["method"] == "Network.webSocketCreated":
                asked.append(message["params"]["url"])
        return asked


# Script that returns the layout faults of an SVG: texts outside the page, and texts that overlap other texts.
SVG_FAULTS = """
const svg = document.querySelector('svg'), page = svg.getBoundingClientRect();
const texts = [...svg.querySelectorAll('text')].filter(t => t.textContent.trim())
    .map(t => ({words: t.textContent, slanted: /rotate/.test(t.getAttribute('transform') || ''), box: t.getBoundingClientRect()}));
const faults = [];
for (const t of texts)
    if (t.box.left < page.left - 1 || t.box.right > page.right + 1 || t.box.top < page.top - 1 || t.box.bottom > page.bottom + 1)
        faults.push(`"${t.words}" reaches out of the page`);
const level = texts.filter(t => !t.slanted).sort((a, b) => a.box.top - b.box.top);
for (let i = 0; i < level.length; ++i)
    for (let j = i + 1; j < level.length && level[j].box.top < level[i].box.bottom; ++j) {
        const a = level[i].box, b = level[j].box, slack = 1.5;
        if (a.left < b.right - slack && b.left < a.right - slack && a.bottom - slack > b.top && b.bottom - slack > a.top)
            faults.push(`"${level[i].words}" lies over "${level[j].words}"`);
    }
return faults.slice(0, 20);
"""

# Script that returns the texts whose contrast with the background is less than 4.5 to 1, or 3 to 1 for large text (WCAG
# 2.1, 1.4.3).
FAINT_TEXTS = """
const colour = text => { const n = text.match(/[\\d.]+/g).map(Number); return n.length < 4 ? [...n, 1] : n; };
const over = (a, b) => [0, 1, 2].map(k => a[k] * a[3] + b[k] * (1 - a[3])).concat(1);
const light = c => [0, 1, 2].map(k => c[k] / 255).map(v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)
    .reduce((sum, v, k) => sum + v * [0.2126, 0.7152, 0.0722][k], 0);
const paper = e => {
    const layers = [];
    for (; e; e = e.parentElement) layers.push(colour(getComputedStyle(e).backgroundColor));
    const dark = getComputedStyle(document.documentElement).colorScheme.includes('dark') &&
        matchMedia('(prefers-color-scheme: dark)').matches;
    return layers.reverse().reduce((below, layer) => over(layer, below), dark ? [18, 18, 18, 1] : [255, 255, 255, 1]);
};
const faults = [];
for (const e of document.querySelectorAll('body *')) {
    if (e.closest('svg') || ![...e.childNodes].some(n => n.nodeType === 3 && n.data.trim()) || !e.checkVisibility()) continue;
    const style = getComputedStyle(e), below = paper(e), ink = over(colour(style.color), below);
    const [low, high] = [light(ink), light(below)].sort((a, b) => a - b), ratio = (high + 0.05) / (low + 0.05);
    const large = parseFloat(style.fontSize) >= 24 || (parseFloat(style.fontSize) >= 18.6 && style.fontWeight >= 700);
    if (ratio < (large ? 3 : 4.5) && !e.matches(':disabled')) faults.push(`${ratio.toFixed(2)}: ${e.textContent.trim().slice(0, 60)}`);
}
return faults.slice(0, 20);
"""

# Script that returns the accessibility faults of a page: controls, fields and pictures without a name; a page without
# language, title, main element or heading; duplicate ids.
UNNAMED = """
const faults = [];
const named = e => (e.getAttribute('aria-label') || e.textContent || e.title || '').trim() ||
    (e.getAttribute('aria-labelledby') || '').split(' ').some(id => id && document.getElementById(id)?.textContent.trim()) ||
    (e.labels && [...e.labels].some(l => l.textContent.trim()));
for (const e of document.querySelectorAll('button, a[href], input, select, textarea, summary, [role=button], [role=slider], [role=tab], [tabindex="0"]'))
    if (e.checkVisibility() && !named(e)) faults.push('no name: ' + e.outerHTML.slice(0, 80));
for (const e of document.querySelectorAll('svg, img'))
    if (e.checkVisibility() && e.getAttribute('aria-hidden') !== 'true' && !e.closest('[aria-hidden=true]') && !named(e) && !e.getAttribute('alt'))
        faults.push('no name: ' + e.outerHTML.slice(0, 80));
if (!document.documentElement.lang) faults.push('the page has no language');
if (!document.title) faults.push('the page has no title');
if (!document.querySelector('main, [role=main]')) faults.push('the page has no main part');
if (!document.querySelector('h1')) faults.push('the page has no heading');
const ids = new Set();
for (const e of document.querySelectorAll('[id]')) { if (ids.has(e.id)) faults.push('twice: #' + e.id); ids.add(e.id); }
return faults.slice(0, 20);
"""

# Script that returns the number of pixels by which the page is wider than its window.
EXCESS_WIDTH = "return document.documentElement.scrollWidth - document.documentElement.clientWidth"


class Case(unittest.TestCase):
    """Base class of browser tests: the tests of a file share a browser, and each test has an empty window."""

    allowed_errors = ()  # parts of console messages that a test provokes

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="grafverif-browser-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        options = Options()
        options.binary_location = CHROMIUM
        for switch in [*SWITCHES, f"--user-data-dir={cls.folder / 'profile'}"]:
            options.add_argument(switch)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        cls.driver = webdriver.Chrome(service=Service(DRIVER), options=options)
        cls.addClassCleanup(cls.driver.quit)
        cls.driver.set_page_load_timeout(30)
        cls.driver.set_script_timeout(30)

    def setUp(self):
        first = self.driver.current_window_handle
        self.driver.switch_to.new_window("tab")
        fresh = self.driver.current_window_handle
        self.driver.switch_to.window(first)
        self.driver.close()
        self.driver.switch_to.window(fresh)
        self.page = Page(self.driver)
        self.page.errors(), self.page.requests()
        self.work = pathlib.Path(tempfile.mkdtemp(dir=self.folder))

    def tearDown(self):
        errors = [e for e in self.page.errors() if not any(part in e for part in self.allowed_errors)]
        self.assertEqual(errors, [], "the console has errors")
        away = [address for address in self.page.requests() if leaves_the_machine(address)]
        self.assertEqual(away, [], "requests leave the machine")


def main():
    reason = why_not()
    if reason:
        print(f"skipped: {reason}")
        sys.exit(SKIPPED)
    unittest.main(verbosity=2)


if __name__ == "__main__":
    print(why_not())
