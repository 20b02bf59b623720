# SPDX-License-Identifier: MIT
"""Tests what the pages of `report`, `serve` and `edit` share: zoom, search, pictures, links, print, empty states."""
import struct
import xml.etree.ElementTree

import browser
from browser import Keys, eventually

STEPS = 100
CONDITIONS = ("START", "!STOP", "датчик", "!停止")
SMALL = """grafcet lamp { input ON; output LAMP; initial step 0; step 1 { LAMP; }
transition on: 0 -> 1 when ON; transition off: 1 -> 0 when !ON; }
closed_loop house { controller lamp with every_cycle; environment B = free(OUT = ON); property p: never LAMP; }
"""
# Script that returns the position of a step in a view, as fractions of the width and height of the view.
PLACE = """const v = document.querySelector(arguments[0]), b = v.getBoundingClientRect(), s = v.querySelector(arguments[1]).getBoundingClientRect();
return [(s.left + s.width / 2 - b.left) / b.width, (s.top + s.height / 2 - b.top) / b.height];"""
TINY = """return [...document.querySelectorAll('button, select, input, summary, a')].filter(e => e.checkVisibility() && !e.closest('p, li, td, nav'))
    .map(e => [e, e.getBoundingClientRect()]).filter(([e, b]) => b.width > 0 && (b.width < 23.5 || b.height < 23.5) && e.type !== 'checkbox')
    .map(([e, b]) => `${e.outerHTML.slice(0, 60)}: ${b.width} x ${b.height}`)"""


def large():
    """A chart of 100 steps with names of several scripts, and a property whose text contains markup characters."""
    lines = ["grafcet große_Anlage {", f"    input {', '.join(c.strip('!') for c in CONDITIONS)};", "    output МОТОР, Lüfter;", "    initial step 0;"]
    lines += [f"    step {k} {{ {'МОТОР' if k % 3 else 'Lüfter'}; }}  // <b>&amp; \"{k}\" '" for k in range(1, STEPS)]
    lines += [f"    transition t{k}: {k} -> {(k + 1) % STEPS} when {CONDITIONS[k % 4]};" for k in range(STEPS)]
    lines += ["}", "closed_loop Werk {", "    controller große_Anlage with every_cycle;"]
    lines += [f"    environment E{k} = free(OUT = {c.strip('!')});" for k, c in enumerate(CONDITIONS)]
    lines += ["    property далеко \"<i>step</i> 6 & 'more'\": never X6;", "    property reached: reachable X3;", "}"]
    return "\n".join(lines) + "\n"


class Views(browser.Case):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.source, cls.made = cls.folder / "große.grafcet", cls.folder / "große.html"
        cls.source.write_text(large(), encoding="utf-8")
        browser.run("report", cls.source, "--timeout", "20s", "-o", cls.made, code=None)

    def report(self, address=""):
        self.page.open("about:blank")
        self.page.open(self.made.resolve().as_uri() + address)
        self.page.wait_for(".player")

    def serve(self, text, command="serve"):
        self.file = self.work / "file.grafcet"
        self.file.write_text(text, encoding="utf-8")
        self.server = browser.Server(self.file, command=command)
        self.addCleanup(lambda: self.server.process.poll() is None and self.server.stop())
        self.page.open(self.server.address)
        self.page.wait_for("#charts > *")

    def level(self, scope=".charts"):
        return int(self.page.text(f"{scope} .zoom-bar output").split()[0])

    def press(self, scope, words):
        [button] = [b for b in self.page.all(f"{scope} .zoom-bar button") if b.text == words]
        self.page.script("arguments[0].scrollIntoView({block: 'center'})", button)
        button.click()

    def wheel(self, selector, x, y, delta):
        """Turns the mouse wheel with Ctrl pressed, at a point of the element given as fractions of its width and
        height."""
        self.page.script("""const v = document.querySelector(arguments[0]), b = v.getBoundingClientRect();
            v.dispatchEvent(new WheelEvent('wheel', {bubbles: true, cancelable: true, ctrlKey: true, deltaY: arguments[3],
                clientX: b.left + b.width * arguments[1], clientY: b.top + b.height * arguments[2]}))""", selector, x, y, delta)

    def test_wheel_keys_and_buttons_zoom_and_the_point_under_the_pointer_stays(self):
        self.report()
        view = ".charts .chart-view"
        self.press(".charts", "100 %")
        self.assertEqual(self.level(), 100)
        self.page.script("const v = document.querySelector(arguments[0]); v.scrollTop = 1500", view)
        step = self.page.script("""const v = document.querySelector(arguments[0]), b = v.getBoundingClientRect();
            return '[data-element="' + [...v.querySelectorAll('.step')].find(s => s.getBoundingClientRect().top > b.top + 60).dataset.element + '"]'""", view)
        x, y = self.page.script(PLACE, view, step)
        self.wheel(view, x, y, -100)
        self.assertGreater(self.level(), 120)
        now = self.page.script(PLACE, view, step)
        self.assertAlmostEqual(now[1], y, delta=0.02)
        self.wheel(view, x, y, 100)
        self.assertEqual(self.level(), 100)
        self.page.find(view).send_keys("+")
        self.assertEqual(self.level(), 125)
        self.page.find(view).send_keys("--")
        self.assertEqual(self.level(), 80)
        self.page.find(view).send_keys("f")
        self.assertLess(self.level(), 30)
        inside = "const v = document.querySelector(arguments[0]); return [v.scrollWidth - v.clientWidth, v.scrollHeight - v.clientHeight]"
        self.assertLessEqual(max(self.page.script(inside, view)), 1, "the complete chart is visible")
        self.page.find(view).send_keys("0")
        self.assertEqual(self.level(), 100)
        before = self.page.script("return [scrollY, page.player.moment]")
        self.page.find(view).send_keys(Keys.SHIFT + Keys.ARROW_DOWN + Keys.NULL)
        self.assertEqual(self.page.script("return [scrollY, page.player.moment]"), before, "neither the page nor the player has moved")

    def test_a_drag_moves_the_drawing_and_is_not_a_click(self):
        self.report()
        view = ".charts .chart-view"
        self.press(".charts", "100 %")
        self.page.find(".charts").location_once_scrolled_into_view
        top = lambda: self.page.script("return document.querySelector(arguments[0]).scrollTop", view)
        self.page.script("document.querySelector(arguments[0]).scrollTop = 800", view)
        box = self.page.script("const b = document.querySelector(arguments[0]).getBoundingClientRect(); return [b.left + b.width / 2, b.top + b.height / 2]", view)
        mouse = lambda kind, dy: self.driver.execute_cdp_cmd("Input.dispatchMouseEvent", {
            "type": kind, "x": box[0], "y": box[1] + dy, "button": "left", "buttons": 1, "clickCount": 1})
        self.page.script("""window.listeners = 0;
            for (const [name, change] of [['addEventListener', 1], ['removeEventListener', -1]]) {
                const original = window[name];
                window[name] = (kind, ...rest) => {
                    if (kind === 'pointercancel') window.listeners += change;
                    original.call(window, kind, ...rest);
                };
            }""")
        self.page.script("window.clicks = 0; document.querySelector(arguments[0]).addEventListener('click', () => ++window.clicks)", view)
        for kind, dy in (("mousePressed", 0), ("mouseMoved", -40), ("mouseMoved", -100), ("mouseReleased", -100)):
            mouse(kind, dy)
        self.assertAlmostEqual(top(), 900, delta=2)
        self.assertEqual(self.page.script("return window.clicks"), 0)
        for kind in ("mousePressed", "mouseReleased"):
            mouse(kind, 0)
        eventually(lambda: self.page.script("return window.clicks") == 1, what="a click without movement")
        self.assertEqual(self.page.script("return window.listeners"), 0, "no listener remains")

    def test_two_fingers_zoom(self):
        self.page.size("phone")
        self.report()
        self.page.script("document.querySelector('.charts .chart-view').scrollIntoView({block: 'center'})")
        before = self.level()
        x, y = self.page.script("const b = document.querySelector('.charts .chart-view').getBoundingClientRect(); return [b.left + b.width / 2, b.top + b.height / 2]")
        touch = lambda kind, apart: self.driver.execute_cdp_cmd("Input.dispatchTouchEvent", {
            "type": kind, "touchPoints": [{"x": x, "y": y - apart, "id": 0}, {"x": x, "y": y + apart, "id": 1}] if apart else []})
        for kind, apart in (("touchStart", 40), ("touchMove", 60), ("touchMove", 80), ("touchEnd", 0)):
            touch(kind, apart)
        eventually(lambda: self.level() >= 1.7 * before, what=f"{self.level()} % instead of {before} %")
        self.assertEqual(self.page.script("return visualViewport.scale"), 1, "the page itself is not zoomed")

    def test_a_large_chart_has_a_map_that_scrolls_it(self):
        self.report("#далеко/4")
        self.press(".charts", "100 %")
        self.assertTrue(self.page.find(".charts .map").is_displayed())
        count = self.page.script("return document.querySelector('.charts .map .blocks').getAttribute('d').split('M').length - 1")
        self.assertEqual(count, STEPS)
        live = self.page.script("return document.querySelector('.charts .map .live').getAttribute('d').split('M').length - 1")
        self.assertEqual(live, 1)
        self.page.script("""const m = document.querySelector('.charts .map'), b = m.getBoundingClientRect();
            m.setPointerCapture = () => {};
            m.dispatchEvent(new PointerEvent('pointerdown', {bubbles: true, clientX: b.left + b.width / 2, clientY: b.bottom - 1}))""")
        below = self.page.script("const v = document.querySelector('.charts .chart-view'); return v.scrollTop / (v.scrollHeight - v.clientHeight)")
        self.assertGreater(below, 0.9)
        frame = lambda: self.page.script("const w = document.querySelector('.charts .map .window'), v = document.querySelector('.charts .chart-view'); return Number(w.getAttribute('y')) - v.scrollTop")
        eventually(lambda: abs(frame()) < 2, what="the frame at the visible part")
        self.press(".charts", "Fit")
        self.assertFalse(self.page.find(".charts .map").is_displayed(), "everything is visible")
        self.serve(SMALL)
        self.page.wait_for("#charts svg.grafcet")
        self.assertFalse(self.page.find("#charts .map").is_displayed(), "the chart is small")

    def here(self, scope):
        return self.page.script("const g = document.querySelector(arguments[0] + ' rect.find.here')?.parentNode; return g ? g.dataset.element ?? g.id : null", scope)

    def visible(self, scope):
        """True if the current match is visible in its view and in the window."""
        return self.page.script("""const r = document.querySelector(arguments[0] + ' rect.find.here'), b = r.getBoundingClientRect(), v = r.closest('.zoomed').getBoundingClientRect();
            return b.top >= v.top && b.bottom <= v.bottom && b.left >= v.left && b.right <= v.right && b.top >= 0 && b.bottom <= innerHeight""", scope)

    def test_steps_and_variables_are_found(self):
        self.report()
        self.page.press("/")
        self.page.press("57")
        self.assertEqual(self.here(".charts"), "step-57")
        self.assertTrue(self.visible(".charts"))
        self.page.press(Keys.CONTROL + "a" + Keys.NULL, "x83")
        self.assertEqual(self.here(".charts"), "step-83")
        self.assertTrue(self.visible(".charts"))
        self.assertEqual(self.page.text("#runs .find-bar output"), "1 of 1")
        self.page.press(Keys.CONTROL + "a" + Keys.NULL, "ДАТЧИК")
        self.assertEqual(self.page.text("#runs .find-bar output"), f"1 of {STEPS // 4}")
        self.assertEqual(self.here(".charts"), "condition-t2")
        self.page.press(Keys.ENTER)
        self.assertEqual(self.here(".charts"), "condition-t6")
        self.assertTrue(self.visible(".charts"))
        self.page.press(Keys.SHIFT + Keys.ENTER + Keys.NULL, Keys.SHIFT + Keys.ENTER + Keys.NULL)
        self.assertEqual(self.here(".charts"), f"condition-t{STEPS - 2}", "the search continues at the end")
        self.page.press(Keys.CONTROL + "a" + Keys.NULL, "<img")
        self.assertEqual(self.page.text("#runs .find-bar output"), "no match")
        self.assertIsNone(self.here(".charts"))
        self.page.press(Keys.ESCAPE)
        self.assertEqual(self.page.all("rect.find"), [])
        self.assertEqual(self.page.script("return document.activeElement.className"), "chart-view zoomed")

    def test_after_a_save_the_search_begins_at_the_first_or_last_match(self):
        self.serve(SMALL)
        self.page.wait_for("#charts svg.grafcet")
        output = lambda: self.page.find(".find-bar output").text
        for keys, place in ((Keys.ENTER, 1), (Keys.SHIFT + Keys.ENTER + Keys.NULL, 3)):
            field = self.page.find(".find-bar input")
            field.clear()
            field.send_keys("ON")
            eventually(lambda: output() == "1 of 3", what=output())
            self.file.write_text(self.file.read_text(encoding="utf-8") + "// saved\n", encoding="utf-8")
            eventually(lambda: output() == "3 found", what=output())
            field.send_keys(keys)
            self.assertEqual(output(), f"{place} of 3")

    def test_the_key_for_the_search_types_itself_in_a_field(self):
        self.report()
        self.page.find(".filters input").send_keys("/")
        self.assertEqual(self.page.script("return document.querySelector('.filters input').value"), "/")
        self.serve(SMALL, "edit")
        self.page.wait_for("#charts svg")
        self.page.find("#text").send_keys("/")
        eventually(lambda: "/" in self.page.script("return document.getElementById('text').value"))
        self.page.find("#charts").send_keys("/")
        self.assertEqual(self.page.script("return document.activeElement.type"), "search")

    def downloads(self):
        folder = self.work / "downloads"
        folder.mkdir()
        self.driver.execute_cdp_cmd("Browser.setDownloadBehavior", {"behavior": "allow", "downloadPath": str(folder)})
        return lambda kind: eventually(lambda: [f.read_bytes() for f in folder.glob(f"*.{kind}") if f.stat().st_size > 0], what=kind)[0]

    def test_a_picture_that_the_browser_cannot_write_is_reported(self):
        self.report()
        self.page.script("HTMLCanvasElement.prototype.toDataURL = () => 'data:,'")
        self.press(".charts", "PNG")
        self.page.wait_for_text(".charts .zoom-bar .problem", "cannot write this drawing as PNG; download it as SVG")

    def test_a_drawing_is_downloaded_with_its_highlights_in_light_colours(self):
        self.page.scheme("dark")
        self.report("#далеко/4")
        wait = self.downloads()
        self.press(".charts", "SVG")
        text = wait("svg").decode("utf-8")
        root = xml.etree.ElementTree.fromstring(text)
        words = {"".join(e.itertext()) for e in root.iter("{http://www.w3.org/2000/svg}text")}
        self.assertLessEqual({"датчик", "МОТОР", "99", '"<b>&amp; "1" \'"'}, words)
        size = [float(root.get(name)) for name in ("width", "height")]
        self.assertEqual(size, [float(each) for each in root.get("viewBox").split()[2:]], "the size is that of the drawing, not of the view")
        for strange in (" class=", " style=", "var(--"):
            self.assertNotIn(strange, text.replace("<b>&amp;", ""))
        self.assertIn("rgb(255, 224, 138)", text, "the active step is yellow")
        self.assertNotIn("rgb(228, 232, 236)", text, "no colour of the dark scheme")
        self.press(".charts", "PNG")
        png = wait("png")
        self.assertEqual(png[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(struct.unpack(">II", png[16:24]), tuple(round(min(2, 16000 / max(size)) * each) for each in size))
        self.assertEqual(self.page.all(".picture"), [])

    def test_a_link_to_a_state_is_copied_and_restores_it(self):
        self.report()
        self.page.script("page.player.go(page.player.run.rowMoments[4])")
        place, caption = self.page.text(".place"), self.page.text(".caption")
        self.page.script("navigator.clipboard.writeText = async (text) => { window.copied = text; }")
        [button] = [b for b in self.page.all(".pick-run button") if b.text == "Copy link"]
        button.click()
        link = eventually(lambda: self.page.script("return window.copied"))
        self.page.wait_for_text(".pick-run button", "Copied")
        self.page.open("about:blank")
        self.page.open(link)
        self.page.wait_for(".player")
        self.assertEqual((self.page.text(".place"), self.page.text(".caption")), (place, caption))
        self.assertFalse(self.page.find("#player > .warning").is_displayed())

    def test_a_link_without_clipboard_is_copied_in_another_way(self):
        self.report()
        self.page.script("""navigator.clipboard.writeText = async () => { throw new Error('denied'); };
            document.execCommand = () => { window.copied = document.activeElement.value; return true; }""")
        self.page.find(".pick-run button").click()
        self.assertIn("#", eventually(lambda: self.page.script("return window.copied")))

    def test_a_link_to_a_run_that_is_missing_is_reported(self):
        self.report("#gone/3")
        self.assertIn("“gone”", self.page.text("#player > .warning"))
        self.assertTrue(self.page.find("#player > .warning").is_displayed())
        self.page.script("page.player.step(1)")
        self.assertFalse(self.page.find("#player > .warning").is_displayed())
        self.report("#charts")
        self.assertFalse(self.page.find("#player > .warning").is_displayed(), "a section is not a run")

    def test_a_verdict_of_serve_leads_to_its_counterexample(self):
        self.serve(SMALL)
        link = eventually(lambda: [a for a in self.page.all("#models .property.bad a") if "counterexample" in a.text], what="the link")[0]
        self.page.open(link.get_attribute("href"))
        self.page.wait_for(".player")
        self.assertEqual(self.page.script("return page.current"), "p")
        self.assertIn("violated here", self.page.text(".standing"))

    def test_a_violated_reachable_of_serve_has_no_link_to_a_run(self):
        self.serve(SMALL.replace("never LAMP", "reachable X0 && X1"))
        self.page.wait_for("#models .property.bad")
        self.assertIn("is violated", self.page.text("#models .property.bad .outcome"))
        self.assertEqual([a.text for a in self.page.all("#models .model.done a")], ["Complete report with trace player"])

    def test_a_report_without_runs_follows_its_address(self):
        source, made = self.work / "held.grafcet", self.work / "held.html"
        source.write_text(SMALL.replace("never LAMP", "never X0 && X1"), encoding="utf-8")
        browser.run("report", source, "-o", made)
        self.page.open(made.resolve().as_uri() + "#p")
        self.assertEqual(self.page.all(".pick-run"), [])
        self.assertTrue(self.page.find("#property-p").get_attribute("open"))
        self.page.script("location.hash = '#gone/3'")
        self.page.wait_for_text("main .warning", "“gone”")
        self.page.script("location.hash = '#p'")
        eventually(lambda: not self.page.find("main .warning").is_displayed())

    def test_the_simulator_reports_that_the_server_has_ended(self):
        self.serve(SMALL)
        self.page.wait_for("#simulation [data-signal]")
        self.server.stop()
        self.page.find("#simulation [data-signal]").click()
        self.page.wait_for_text("#simulation .problem", "grafverif does not respond; restart it")
        self.allowed_errors = ("ERR_CONNECTION", "Failed to load resource")

    def test_verdicts_and_charts_are_printed_and_controls_are_not(self):
        self.page.scheme("dark")
        self.report("#далеко/4")
        self.press(".charts", "100 %")
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print", "features": [{"name": "prefers-color-scheme", "value": "dark"}]})
        self.addCleanup(lambda: self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""}))
        shown = self.page.script("return [...document.querySelectorAll('button:not(.link), input, .map')].filter(e => e.checkVisibility()).map(e => e.outerHTML.slice(0, 60))")
        self.assertEqual(shown, [])
        self.assertEqual(self.page.script("return getComputedStyle(document.body).backgroundColor"), "rgb(255, 255, 255)")
        wide = self.page.script("""return [...document.querySelectorAll('svg.grafcet')].map(s => [s.getBoundingClientRect(), s.parentNode.getBoundingClientRect(), s.viewBox.baseVal])
            .filter(([s, p, v]) => s.width > p.width + 1 || Math.abs(s.width / s.height - v.width / v.height) > 0.01).length""")
        self.assertEqual(wide, 0, "each chart has the width of its page at most, and keeps its proportions")
        self.assertTrue(self.page.find("#property-далеко .outcome").is_displayed())

    def test_in_serve_the_scale_and_the_position_survive_a_save(self):
        self.serve(large())
        self.page.wait_for("#charts svg.grafcet")
        for _ in range(2):
            self.press("#charts", "+")
        self.page.script("document.querySelector('#charts .drawing').scrollTop = 2000")
        level = self.level("#charts")
        self.file.write_text(large().replace("Lüfter", "вентилятор"), encoding="utf-8")
        eventually(lambda: "вентилятор" in (self.page.text("#charts svg.grafcet") or ""))
        self.assertEqual(self.level("#charts"), level)
        self.assertAlmostEqual(self.page.script("return document.querySelector('#charts .drawing').scrollTop"), 2000, delta=150)
        self.page.find("body").send_keys("/")
        self.page.press("вентилятор")
        self.assertTrue(self.visible("#charts"))
        self.assertIn("action", self.here("#charts") or "")

    def test_in_edit_a_click_selects_the_element_at_every_scale(self):
        self.serve(large(), "edit")
        self.page.wait_for("#charts svg.grafcet")
        for words in ("Fit", "100 %", "+", "+"):
            self.press("#drawings", words)
            if words == "Fit":
                continue
            self.page.script("document.getElementById('c0-step-40').scrollIntoView({block: 'center'})")
            self.page.find("#c0-step-40 > text").click()
            self.page.wait_for_text("#selection", "step 40")
            mark, step = (self.page.script(f"const b = document.querySelector('{s}').getBoundingClientRect(); return [b.left + b.width / 2, b.top + b.height / 2]")
                          for s in ("#charts .choice", "#c0-step-40 > rect"))
            self.assertAlmostEqual(mark[0], step[0], delta=2)
            self.assertAlmostEqual(mark[1], step[1], delta=2)
            self.page.find("#charts").send_keys(Keys.HOME)
            self.page.wait_for_text("#selection", "step 0")
        self.page.find("#charts").send_keys(Keys.F2)
        field = self.page.script("const f = document.getElementById('in-place').getBoundingClientRect(), v = document.getElementById('charts').getBoundingClientRect(); return [f.top - v.top, v.bottom - f.bottom]")
        self.assertGreaterEqual(min(field), 0, "the field is visible")
        self.page.find("#in-place input").send_keys(Keys.ESCAPE)
        self.page.find("#charts").send_keys("/")
        self.page.press("X77")
        self.page.wait_for_text("#selection", "step 77")
        self.assertEqual(self.here("#charts"), "c0-step-77")

    def test_in_edit_a_changed_drawing_keeps_its_scale(self):
        self.serve(SMALL, "edit")
        self.page.wait_for("#charts svg.grafcet")
        self.press("#drawings", "+")
        self.page.find("#charts").send_keys(Keys.HOME, "a")
        self.page.wait_for("#c0-step-2")
        ratio = "const s = document.querySelector('#charts svg'); return s.getBoundingClientRect().height / s.viewBox.baseVal.height"
        eventually(lambda: abs(self.page.script(ratio) - self.level("#drawings") / 100) < 0.01, what="the scale of the new size")

    def test_empty_files_and_errors_are_explained(self):
        self.serve("// nothing\n")
        eventually(lambda: len(self.page.all(".empty")) >= 3)
        shown = " ".join(self.page.script("return [...document.querySelectorAll('.empty')].filter(e => e.checkVisibility()).map(e => e.textContent)"))
        for part in ("The file has no chart", "There is nothing to check", "There is nothing to simulate"):
            self.assertIn(part, shown)
        self.assertFalse(self.page.find("#charts").find_elements("css selector", "svg"))
        self.assertFalse(self.page.all(".find-bar")[0].is_displayed(), "there is nothing to find")
        self.file.write_text(SMALL.replace("property p: never LAMP;", ""))
        eventually(lambda: "No properties are declared" in (self.page.text("#models") or ""))
        self.server.stop()
        self.serve("grafcet {")
        self.page.wait_for_text("#simulation", "as soon as the file has no errors")
        self.page.wait_for_text("#charts", "Correct the errors above")
        self.assertEqual(self.page.find("#status").get_attribute("class"), "bad")
        self.server.stop()
        self.serve("// nothing\n", "edit")
        self.page.wait_for_text("#charts", "There is no chart to draw")
        self.page.find("#text").send_keys(Keys.CONTROL + "a" + Keys.NULL, "grafcet g { initial step 0; }")
        self.page.wait_for("#c0-step-0")
        self.assertNotIn("There is no chart", self.page.text("#charts"))
        self.allowed_errors = ("ERR_CONNECTION", "Failed to load resource")

    def test_the_pages_share_their_design(self):
        colours = """const s = getComputedStyle(document.documentElement);
            return ['--paper', '--ink', '--good', '--bad', '--warn', '--accent', '--s2', '--radius'].map(n => s.getPropertyValue(n).trim())"""
        found = {}
        for scheme in browser.SCHEMES:
            self.page.scheme(scheme)
            self.report()
            report = self.page.script(colours)
            self.assertTrue(all(report), report)
            for command in ("serve", "edit"):
                self.serve(SMALL, command)
                self.assertEqual(self.page.script(colours), report, f"{command}, {scheme}")
                self.server.stop()
            found[scheme] = report
        self.assertNotEqual(found["light"], found["dark"])
        self.allowed_errors = ("ERR_CONNECTION", "Failed to load resource")

    def test_on_a_phone_nothing_is_cut_off_and_targets_are_large(self):
        self.page.size("phone")
        def check(what):
            self.assertLessEqual(self.page.script(browser.EXCESS_WIDTH), 0, what)
            self.assertEqual(self.page.script(TINY), [], what)
            self.assertEqual(self.page.script(browser.UNNAMED), [], what)
            self.page.screenshot(f"view-{what}")
        self.report("#далеко/4")
        check("report")
        for command in ("serve", "edit"):
            self.serve(large(), command)
            self.page.wait_for("#charts svg.grafcet")
            eventually(lambda: self.page.all("#models .property"), what="verdicts")
            check(command)
            self.server.stop()
        self.allowed_errors = ("ERR_CONNECTION", "Failed to load resource")

    def test_texts_of_a_model_are_not_markup(self):
        self.report("#далеко/4")
        self.assertIn("<i>step</i> 6 & 'more'", self.page.text("#property-далеко"))
        self.assertEqual(self.page.all("i, b"), [])
        self.assertIn("große_Anlage", self.page.text("figcaption"))


if __name__ == "__main__":
    browser.main()
