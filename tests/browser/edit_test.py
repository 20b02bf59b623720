# SPDX-License-Identifier: MIT
"""Tests the page of `edit` in a browser: mouse and keyboard operations, the text editor, undo, and files."""
import json
import os
import signal
import urllib.error
import urllib.request

import browser
from browser import Keys

PRESS = """// A press.
grafcet press {
    input START, DOWN, UP;
    output GO_DOWN, GO_UP;

    initial step 0;
    step 1 { GO_DOWN; }  // down
    step 2 { GO_UP; }

    transition start: 0 -> 1 when START;
    transition down: 1 -> 2 when DOWN;
    transition up: 2 -> 0 when UP;
}

closed_loop hall {
    controller press with stability_search;
    environment A = free(OUT = START);
    environment B = free(OUT = DOWN);
    environment C = free(OUT = UP);
    property EXCLUSIVE: never GO_DOWN && GO_UP;
    property SHUT: never GO_UP;
}
"""


class Edit(browser.Case):
    allowed_errors = ("Failed to load resource",)

    def edit(self, text=PRESS, *options):
        self.file = self.work / "press.grafcet"
        if text is not None:
            self.file.write_text(text)
        errors = open(self.work / "stderr.txt", "w")
        self.addCleanup(errors.close)
        self.server = browser.Server(self.file, *options, command="edit", stderr=errors)
        self.addCleanup(lambda: self.server.process.poll() is None and self.server.stop())
        self.page.open(self.server.address)
        self.page.wait_for("#charts svg")

    def text(self):
        return self.page.script("return document.getElementById('text').value")

    def wait_for_text(self, part, absent=False):
        browser.eventually(lambda: (part in self.text()) != absent, what=f"`{part}` in {self.text()}")

    def click(self, element):
        self.page.script("""const box = document.querySelector(`#${arguments[0]} > rect, #${arguments[0]} > text`).getBoundingClientRect();
            document.getElementById(arguments[0]).dispatchEvent(new MouseEvent("click", {
                bubbles: true, clientX: box.x + box.width / 2, clientY: box.y + box.height / 2}))""", element)

    def press(self, words):
        def press():
            for button in self.page.all("#operations button, header button, #in-place button, #conflict button"):
                if button.text.startswith(words) and button.is_enabled():
                    button.click()
                    return True
        browser.eventually(press, what=words)

    def keys(self, *keys):
        self.page.find("#charts").send_keys(*keys)

    def control(self, key):
        self.page.press(Keys.CONTROL + key + Keys.NULL)

    def fill(self, text):
        field = self.page.wait_for("#in-place input")
        field.clear()
        field.send_keys(text, Keys.ENTER)

    def type_at_end(self, text):
        self.page.find("#text").send_keys(Keys.CONTROL + Keys.END + Keys.NULL, text)

    def test_steps_and_branches_are_added_by_clicking_and_the_text_keeps_its_comments(self):
        self.edit()
        self.page.find("#c0-step-1 > text").click()
        self.assertIn("step 1", self.page.text("#selection"))
        self.press("Step after")
        self.wait_for_text("step 3;")
        self.page.wait_for("#c0-step-3")
        self.assertIn("step 1 { GO_DOWN; }  // down\n    step 3;\n", self.text())
        self.assertIn("transition t4: 1 -> 3 when true;", self.text())
        self.assertIn("step 3", self.page.text("#selection"))
        self.click("c0-condition-t4")
        self.press("Edit")
        self.fill("DOWN && !UP")
        self.wait_for_text("1 -> 3 when DOWN && !UP;")
        self.click("c0-step-3")
        self.press("Action")
        self.fill("GO_UP if UP")
        self.wait_for_text("step 3 { GO_UP if UP; }")
        self.press("Parallel")
        self.wait_for_text("1 -> 3, 4 when")
        self.press("Jump to")
        self.click("c0-step-0")
        self.wait_for_text("4 -> 0 when")
        for _ in range(5):
            self.press("Undo")
            self.page.script("return page.queue")
        browser.eventually(lambda: self.text() == PRESS, what="the first text")
        self.assertEqual(self.file.read_text(), PRESS)
        self.press("Redo")
        self.wait_for_text("step 3;")

    def test_everything_works_by_keys(self):
        self.edit()
        self.keys(Keys.HOME)
        self.assertIn("step 0", self.page.text("#selection"))
        self.keys(Keys.ARROW_DOWN)
        self.assertIn("transition start", self.page.text("#selection"))
        self.keys(Keys.ENTER)
        self.fill("START && !DOWN")
        self.wait_for_text("when START && !DOWN;")
        self.keys(Keys.ARROW_DOWN)
        self.assertIn("step 1", self.page.text("#selection"))
        self.keys("a")
        self.wait_for_text("step 3;")
        self.keys(Keys.F2)
        self.fill("30")
        self.wait_for_text("step 30;")
        self.keys("l")
        self.wait_for_text("30 -> 31")
        self.keys(Keys.HOME, "j", Keys.ARROW_DOWN, Keys.ARROW_DOWN, Keys.ENTER)
        self.wait_for_text("0 -> 1 when !(START && !DOWN)")
        self.keys(Keys.DELETE)
        self.wait_for_text("0 -> 1 when !(START && !DOWN)", absent=True)
        for key in "zzy":
            self.control(key)
        self.control("s")
        browser.eventually(lambda: self.file.read_text() == self.text() != PRESS, what="saved")
        browser.eventually(lambda: self.page.text("#saved") == "Saved", what="the status")
        self.control("e")
        self.assertEqual(self.page.script("return document.activeElement.id"), "text")
        self.page.press(Keys.F1)
        self.assertIn("add an alternative branch", self.page.find("#help").text)
        self.page.screenshot("edit-keys")

    def test_steps_are_copied_and_pasted_with_new_names(self):
        self.edit()
        self.page.find("#c0-step-1 > text").click()
        self.page.script("""const box = document.querySelector("#c0-step-2 > rect").getBoundingClientRect();
            document.getElementById("c0-step-2").dispatchEvent(new MouseEvent("click", {
                bubbles: true, shiftKey: true, clientX: box.x + box.width / 2, clientY: box.y + box.height / 2}))""")
        self.assertIn("marked: 1, 2", self.page.text("#selection"))
        self.assertEqual(len(self.page.all("#charts .choice.mark")), 2)
        self.page.screenshot("edit-marked")
        self.keys(Keys.CONTROL, "c")
        self.page.wait_for_text("#selection", "Copied: step 1, step 2")
        self.click("c0-transition-start")
        self.keys(Keys.CONTROL, "v")
        self.wait_for_text("step 3 { GO_DOWN; }\n    step 4 { GO_UP; }\n")
        self.wait_for_text("transition t4: 0 -> 3 when !START;\n    transition t5: 3 -> 4 when DOWN;\n    transition t6: 4 -> 1 when UP;")
        self.page.wait_for("#c0-step-4")
        self.assertIn("step 3", self.page.text("#selection"))
        self.control("z")
        browser.eventually(lambda: self.text() == PRESS, what="the text before the paste")
        self.keys(Keys.HOME, "m", Keys.ARROW_DOWN, Keys.ARROW_DOWN, "m", "m")
        self.assertIn("Selected: step 1; marked: 0", self.page.text("#selection"))
        self.keys(Keys.ESCAPE)
        self.assertEqual(self.page.text("#selection"), "Nothing is selected.")

    def test_names_are_completed_in_fields_and_in_the_text(self):
        self.edit()
        self.click("c0-condition-down")
        self.keys("e")
        field = self.page.wait_for("#in-place input")
        field.send_keys(Keys.END, " && U")
        self.page.wait_for_text("#in-place .proposals", "input UP")
        self.page.screenshot("edit-proposals")
        field.send_keys(Keys.ARROW_DOWN, Keys.ENTER)
        self.assertEqual(field.get_attribute("value"), "DOWN && UP")
        field.send_keys(" && X")
        self.page.wait_for_text("#in-place .proposals", "X2")
        field.send_keys(Keys.ESCAPE)
        self.assertTrue(self.page.all("#in-place"), "Esc closes only the list")
        field.send_keys("2", Keys.ENTER)
        self.wait_for_text("1 -> 2 when DOWN && UP && X2;")
        self.click("c0-step-2")
        self.keys("n")
        field = self.page.wait_for("#in-place input")
        field.send_keys("GO_D")
        self.page.wait_for_text("#in-place .proposals", "GO_DOWN")
        field.send_keys(Keys.TAB, Keys.ENTER)
        self.wait_for_text("step 2 { GO_UP; GO_DOWN; }")
        self.page.script("const f = document.getElementById('text'); f.focus(); const at = f.value.indexOf('START;', 200); f.setSelectionRange(at, at)")
        self.page.find("#text").send_keys("DO")
        self.page.wait_for_text("#field .proposals", "input DOWN")
        self.page.screenshot("edit-proposals-text")
        self.page.find("#text").send_keys(Keys.TAB, " && ")
        self.wait_for_text("0 -> 1 when DOWN && START;")

    def test_a_closed_loop_is_assembled_with_proposals(self):
        self.edit()
        self.page.find("#text").click()
        self.page.script("const f = document.getElementById('text'); f.focus(); const at = f.value.indexOf('    property'); f.setSelectionRange(at, at)")
        self.page.press("    plant RAM = cyl")
        self.page.wait_for_text("#field .proposals", "component cylinder")
        self.page.press(Keys.TAB)
        self.page.wait_for_text("#field .proposals", "output GO_UP")
        self.page.screenshot("edit-component")
        self.page.press("GO_U")
        self.page.wait_for_text("#field .proposals b", "GO_UP")
        self.page.press(Keys.TAB)
        self.assertRegex(self.text(), r"plant RAM = cylinder\w*\(\w+ = GO_UP, ")

    def test_variables_partial_charts_and_macro_steps_are_added(self):
        self.edit()
        self.press("Variable")
        self.fill("DOOR")
        self.wait_for_text("input START, DOWN, UP;\n    input DOOR;\n")
        self.wait_for_text("OUT = UP);\n    environment DOOR_any = free(OUT = DOOR);\n")
        self.press("Variable")
        self.page.script("const s = document.querySelector('#in-place select'); s.value = 'internal'; s.dispatchEvent(new Event('change'))")
        self.page.screenshot("edit-variable")
        self.fill("n: bool")
        self.wait_for_text("    internal n: bool;\n")
        self.press("Partial chart")
        self.fill("G2")
        self.wait_for_text("    partial G2 {\n        initial step 3;\n    }\n}")
        self.page.find("#c0-step-1 > text").click()
        self.press("Macro-step")
        self.wait_for_text("macro step 4 expands E1;")
        self.press("Enclosing step")
        self.fill("G3")
        self.wait_for_text("enclosing step 5 encloses G3;")
        self.page.wait_for("#c0-step-5")
        self.page.screenshot("edit-parts")
        for _ in range(5):
            self.press("Undo")
            self.page.script("return page.queue")
        browser.eventually(lambda: self.text() == PRESS, what="the first text")

    def test_a_rejected_operation_leaves_the_text_and_shows_its_reason(self):
        self.edit(PRESS.replace("when UP;", "when UP && X2;"))
        before = self.text()
        self.click("c0-transition-start")
        self.press("Delete")
        self.page.wait_for_text("#problem", "no transition leads to step `1`".replace("`", ""))
        self.click("c0-condition-down")
        self.keys("e")
        field = self.page.wait_for("#in-place input")
        field.send_keys(Keys.END, " && DOWNN")
        self.page.wait_for_text("#in-place .problem", "unknown variable DOWNN")
        self.page.screenshot("edit-in-place")
        field.send_keys(Keys.ENTER)
        self.page.wait_for_text("#in-place .problem", "DOWNN")
        field.send_keys(Keys.ESCAPE)
        self.assertFalse(self.page.all("#in-place"))
        self.assertEqual(self.text(), before)

    def test_a_condition_of_several_lines_keeps_its_lines(self):
        self.edit(PRESS.replace("when DOWN;", "when DOWN  // sensor\n        && !UP;"))
        self.click("c0-transition-down")
        self.page.wait_for_text("#selection", "down")
        self.press("Edit")
        field = self.page.wait_for("#in-place textarea")
        field.send_keys(Keys.CONTROL, Keys.END)
        field.send_keys(" && !START")
        self.press("Apply")
        self.wait_for_text("when DOWN  // sensor\n        && !UP && !START;")

    def test_broken_text_keeps_the_last_drawing_until_it_is_repaired(self):
        self.edit()
        self.type_at_end("grafcet broken {")
        browser.eventually(lambda: self.page.all("#charts.stale"), what="the old drawing")
        self.assertTrue(self.page.find("#drawings .before").is_displayed())
        self.assertTrue(self.page.all("#diagnostics .error"))
        self.assertTrue(self.page.all("#c0-step-1"))
        self.assertFalse([button for button in self.page.all("#operations button") if button.is_enabled()])
        self.page.wait_for_text("#status", "the text has errors")
        self.page.screenshot("edit-broken")
        self.type_at_end(" initial step 0; }")
        browser.eventually(lambda: not self.page.all("#charts.stale"), what="the new drawing")
        self.page.wait_for("#c1-step-0")
        self.page.find("#diagnostics, #text")
        while self.page.find("#undo").is_enabled():
            self.control("z")
            self.page.script("return page.queue")
        browser.eventually(lambda: self.text() == PRESS, what="the first text")

    def test_selection_is_the_same_in_drawing_and_text(self):
        self.edit()
        self.click("c0-condition-down")
        selected = "const f = document.getElementById('text'); return f.value.slice(f.selectionStart, f.selectionEnd)"
        self.assertEqual(self.page.script(selected), "transition down: 1 -> 2 when DOWN;")
        self.page.script("const f = document.getElementById('text'); f.focus(); const at = f.value.indexOf('GO_UP; }'); f.setSelectionRange(at, at)")
        self.page.wait_for_text("#selection", "action GO_UP")
        self.page.wait_for("#charts .choice")

    def test_verdicts_are_updated_while_editing(self):
        self.edit()
        self.page.wait_for_text("#status", "not as expected")
        self.assertIn("SHUT is violated, unexpectedly", self.page.text("#models"))
        self.click("c0-action-c1")
        self.press("Delete")
        self.page.wait_for_text("#models", "SHUT holds")

    def test_a_model_that_cannot_be_checked_has_a_reason(self):
        self.edit(PRESS.replace("when START;", "when rise(rise(START) && UP);"))
        self.page.wait_for_text("#models", "This model cannot be checked.")
        self.assertIn("[edge-of-edge]", self.page.text("#reasons"))

    def test_two_windows_do_not_overwrite_each_other(self):
        self.edit()
        first = self.page.driver.current_window_handle
        self.page.driver.switch_to.new_window("tab")
        self.page.open(self.server.address)
        self.page.wait_for("#charts svg")
        self.click("c0-step-2")
        self.press("Step after")
        self.wait_for_text("step 3;")
        second = self.page.driver.current_window_handle
        self.page.driver.switch_to.window(first)
        self.wait_for_text("step 3;")
        self.page.driver.switch_to.window(second)
        self.page.driver.close()
        self.page.driver.switch_to.window(first)

    def test_the_simulator_highlights_the_drawing(self):
        self.edit()
        self.assertFalse(self.page.all(".active .token"))
        self.page.find("#simulating summary").click()
        self.page.wait_for("#simulation select option")
        self.page.wait_for("#c0-step-0.active .token")
        self.click("c0-step-0")
        self.press("Step after")
        self.page.wait_for("#c0-step-3.active .token")  # the new condition is `true`
        self.page.find("#simulating summary").click()
        browser.eventually(lambda: not self.page.all(".active .token"), what="no token")

    def test_a_change_elsewhere_is_never_overwritten(self):
        self.edit()
        self.file.write_text(PRESS.replace("// down", "// elsewhere"))
        self.wait_for_text("// elsewhere")
        self.assertEqual(self.page.text("#saved"), "Saved")
        self.click("c0-step-2")
        self.press("Step after")
        self.wait_for_text("step 3;")
        other = PRESS.replace("// down", "// third")
        self.file.write_text(other)
        browser.eventually(lambda: self.page.find("#conflict").is_displayed(), what="the conflict")
        self.assertIn("// third", self.page.text("#file-text mark"))
        self.assertIn("step 3;", self.page.text("#page-text"))
        self.page.screenshot("edit-conflict")
        self.control("s")
        self.page.wait_for_text("#problem", "another program has changed the file")
        self.assertEqual(self.file.read_text(), other)
        self.press("Use the text")
        self.wait_for_text("// third")
        self.assertEqual(self.text(), other)
        self.press("Undo")
        self.wait_for_text("step 3;")
        self.file.write_text(PRESS)
        browser.eventually(lambda: self.page.find("#conflict").is_displayed(), what="the conflict")
        self.press("Keep the text")
        browser.eventually(lambda: not self.page.find("#conflict").is_displayed(), what="no conflict")
        self.control("s")
        browser.eventually(lambda: "step 3;" in self.file.read_text(), what="saved")

    def test_unsaved_work_survives_a_closed_tab_and_a_killed_server(self):
        self.edit()
        self.click("c0-step-2")
        self.press("Step after")
        self.wait_for_text("step 3;")
        self.page.open("about:blank")
        self.page.open(self.server.address)
        self.wait_for_text("step 3;")
        recovery = self.work / ".press.grafcet.unsaved"
        browser.eventually(recovery.exists, what="the recovery file")
        self.server.process.send_signal(signal.SIGKILL)
        self.server.process.wait()
        self.page.open("about:blank")
        self.assertEqual(self.file.read_text(), PRESS)
        self.edit(None)
        self.wait_for_text("step 3;")
        self.assertIn("earlier session", self.page.text("#notices"))
        self.press("Save")
        browser.eventually(lambda: not recovery.exists(), what="no recovery file")
        self.assertIn("step 3;", self.file.read_text())
        self.assertEqual(self.page.text("#notices"), "")

    def test_a_stopped_server_names_the_recovery_file(self):
        self.edit()
        self.click("c0-step-2")
        self.press("Step after")
        self.wait_for_text("step 3;")
        self.server.stop()
        self.assertIn("the next `grafverif edit` restores them", (self.work / "stderr.txt").read_text())
        self.assertIn("step 3;", json.loads((self.work / ".press.grafcet.unsaved").read_text())["text"])
        self.page.wait_for_text("#status", "does not respond")

    def test_a_read_only_file_is_reported(self):
        if os.geteuid() == 0:
            self.skipTest("root can write every file")
        self.file = self.work / "press.grafcet"
        self.file.write_text(PRESS)
        self.file.chmod(0o444)
        self.edit(None)
        self.assertIn("read-only", self.page.text("#notices"))
        self.assertFalse(self.page.find("#save").is_enabled())

    def test_line_ends_and_characters_of_the_file_are_kept(self):
        text = PRESS.replace("// down", "// \U0001f600 hinunter \u2193").replace("\n", "\r\n")
        self.file = self.work / "press.grafcet"
        self.file.write_bytes(text.encode())
        self.edit(None)
        self.click("c0-condition-up")
        selected = "const f = document.getElementById('text'); return f.value.slice(f.selectionStart, f.selectionEnd)"
        self.assertEqual(self.page.script(selected), "transition up: 2 -> 0 when UP;")
        self.type_at_end("// end\n")
        self.control("s")
        browser.eventually(lambda: self.file.read_bytes() == (text + "// end\r\n").encode(), what="saved")

    def test_hostile_texts_are_texts(self):
        self.edit(PRESS.replace("// down", "// <img src=x onerror=alert(1)></textarea><script>shout()</script>"))
        self.assertEqual(self.page.all("img") + self.page.all("body script"), [])
        self.type_at_end("<script>")
        browser.eventually(lambda: self.page.all("#diagnostics .error"), what="the error")
        self.assertEqual(self.page.all("body script"), [])

    def test_requests_need_the_token_and_the_current_version(self):
        self.edit()
        address = f"http://127.0.0.1:{self.server.port}"

        def post(path, body, **headers):
            request = urllib.request.Request(address + path, json.dumps(body).encode(), headers)
            return json.load(urllib.request.urlopen(request, timeout=20))

        for headers in ({}, {"X-Grafverif-Token": self.server.token, "Origin": "http://example.org"}):
            with self.assertRaises(urllib.error.HTTPError) as refused:
                post("/text", {"version": 2, "text": ""}, **headers)
            self.assertEqual(refused.exception.code, 403)
        token = {"X-Grafverif-Token": self.server.token}
        self.assertIn("in the meantime", post("/text", {"version": 77, "text": ""}, **token)["problem"])
        self.assertIn("malformed", post("/edit", {"version": 2, "operation": "explode", "at": 1}, **token)["problem"])
        self.assertIn("malformed", post("/edit", [], **token)["problem"])
        self.assertIn("not in this text", post("/edit", {"version": 2, "operation": "delete", "at": 1}, **token)["problem"])
        self.assertEqual(self.file.read_text(), PRESS)

    def test_it_can_be_read_at_every_size_in_both_schemes_and_by_a_screen_reader(self):
        self.edit()
        self.page.wait_for_text("#status", "not as expected")
        self.click("c0-step-1")
        for size in browser.SIZES:
            for scheme in browser.SCHEMES:
                self.page.size(size)
                self.page.scheme(scheme)
                self.page.screenshot(f"edit-{size}-{scheme}")
                with self.subTest(size=size, scheme=scheme):
                    self.assertEqual(self.page.script(browser.FAINT_TEXTS), [])
                    self.assertEqual(self.page.script(browser.UNNAMED), [])
                    self.assertLessEqual(self.page.script(browser.EXCESS_WIDTH), 0)


if __name__ == "__main__":
    browser.main()
