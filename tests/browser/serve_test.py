# SPDX-License-Identifier: MIT
"""Tests the page of `serve` in a browser."""
import re
import shutil

import browser

OVEN = browser.SOURCE / "samples/oven_door/oven_door.grafcet"
LAMP = """grafcet lamp { input ON, OFF, N: int 0..9; output LAMP; internal count: int 0..99; constraint !(ON && OFF);
initial step 0; step 1 { LAMP; count := count + 1 on activation; }
transition on: 0 -> 1 when ON; transition off: 1 -> 0 when OFF && !ON || 3s/X1; }
"""


class Serve(browser.Case):
    def serve(self, text):
        self.file = self.work / "file.grafcet"
        self.file.write_text(text)
        server = browser.Server(self.file)
        self.addCleanup(server.stop)
        self.page.open(server.address)
        self.page.wait_for("#simulation select option")
        return server

    def press(self, words):
        """Clicks the button with the text `words` as soon as it is enabled, and waits for the response to it."""
        def press():
            for button in self.page.all("#simulation button"):
                if button.text == words and button.is_enabled():
                    button.click()
                    return True
        before = self.page.script("return page.simulator.answers")
        browser.eventually(press, what=words)
        browser.eventually(lambda: self.page.script("return page.simulator.answers") > before, what=f"the answer to {words}")

    def last_row(self):
        return (self.page.texts("#simulation tbody tr:last-child td") or [""])

    def wait_for_row(self, part):
        browser.eventually(lambda: part in " | ".join(self.last_row()), what=f"{part} in {self.last_row()}")

    def test_the_oven_door_is_simulated_to_its_end(self):
        self.serve(OVEN.read_text())
        self.page.wait_for("#c0-step-0.active .token")
        self.press("Next")
        self.press("START is false")
        self.wait_for_row("LIGHT")
        self.page.wait_for("#c0-step-1.active .token")
        self.assertEqual(self.page.all("#c0-step-0.active"), [])
        self.press("Wait")  # 1 s, as the page proposes: the button is released 1 s after it is pressed
        self.press("START is true")
        self.wait_for_row("CLOSE")
        for _ in range(60):
            if "0" == self.last_row()[3]:
                break
            self.press("Next")
            self.page.wait_for_text("#simulation p", "moves")
        outputs = {each.split()[0] for each in self.page.texts("#simulation .values .on")}
        self.assertIn("LOCK", outputs)
        self.assertNotIn("LIGHT", outputs)
        browser.eventually(lambda: "as expected" in self.page.text("#status"), what="the verdicts")
        self.page.wait_for("#c0-step-0.active .token")
        self.page.script("scrollTo(0, 0)")
        self.page.screenshot("serve-oven")

    def test_the_complete_report_is_one_click_away(self):
        self.serve(LAMP)
        link = browser.eventually(lambda: self.page.all(".model a"), what="the link")[0]
        self.page.open(link.get_attribute("href"))
        self.page.wait_for("#verdicts, #properties, h2")
        self.assertIn("lamp", self.page.text("body"))
        self.assertGreater(len(self.page.all("svg")), 0)

    def test_a_broken_save_shows_its_caret_and_a_mended_one_the_chart_again(self):
        self.serve(LAMP)
        self.assertFalse(self.page.find("#diagnostics-text").is_displayed())
        self.file.write_text(LAMP.replace("when ON;", "when ONN;"))
        browser.eventually(lambda: self.page.find("#diagnostics-text").is_displayed(), what="the diagnostics")
        diagnostics = self.page.text("#diagnostics-text")
        self.assertIn("unknown variable", diagnostics)
        self.assertIn("^", diagnostics.splitlines()[2])
        self.assertIn("errors", self.page.text("#status"))
        self.page.screenshot("serve-broken")
        self.file.write_text(LAMP)
        browser.eventually(lambda: not self.page.find("#diagnostics-text").is_displayed(), what="no diagnostics")

    def test_outdated_results_are_marked(self):
        server = self.serve(LAMP)
        browser.eventually(lambda: "as expected" in self.page.text("#status"), what="the verdicts")
        old = self.page.find("#verdicts .before").is_displayed
        self.assertFalse(old())
        self.file.write_text("grafcet")
        browser.eventually(old, what="the verdicts are old")
        self.file.write_text(LAMP)
        browser.eventually(lambda: not old(), what="new verdicts")
        server.stop()
        self.page.wait_for_text("#status", "does not respond")
        self.assertTrue(old())
        self.allowed_errors = ("ERR_CONNECTION", "Failed to load resource")

    def test_no_success_is_shown_while_a_part_is_rejected_or_unknown(self):
        refused = ("grafcet bad { input A, B; initial step 0; step 1; transition on: 0 -> 1 when rise(rise(A) && B); transition off: 1 -> 0 when !A; }\n"
                   "closed_loop yard { controller bad with stability_search; environment A1 = free(OUT = A); environment B1 = free(OUT = B); }\n")
        self.serve(LAMP + refused)
        self.page.wait_for_text("#status", "a part of the file cannot be checked")
        self.assertEqual(self.page.find("#status").get_attribute("class"), "bad")
        self.assertIn("Closed loop yard", self.page.text("#models"))
        self.assertIn("This model cannot be checked.", self.page.text("#models"))
        self.file.write_text("grafcet lamp { input ON; output LAMP; initial step 0; step 1 { LAMP; } transition on: 0 -> 1 when ON; transition off: 1 -> 0 when !ON; }\n"
                             "closed_loop house { controller lamp with stability_search; environment On = push_button(OUT = ON);\n"
                             "observer Eye { initial location 100; location 101; 100 -> 101 when LAMP; }\n"
                             "property SEEN: never Eye.101; property DARK: X0 && !X0 leads to LAMP; }\n")
        self.page.wait_for_text("#status", "undecided")
        self.assertEqual(self.page.find("#status").get_attribute("class"), "unknown")
        self.assertNotIn("not as expected", self.page.text("#status"))
        self.assertIn("? SEEN is unknown", self.page.text("#models"))
        self.assertIn("DARK holds vacuously", self.page.text("#models"))

    def test_a_chart_alone_is_played_with_and_its_session_is_an_address(self):
        server = self.serve(LAMP)
        self.press("ON is false")
        self.wait_for_row("LAMP")
        self.page.wait_for("#c0-transition-on.cleared .tick")
        self.press("ON is true")
        self.page.wait_for_text("#simulation p", "2 moves")
        self.press("Next")
        self.wait_for_row("none")
        self.page.wait_for_text("#simulation p", "3 s since power-on, 3 moves")
        address = self.page.driver.current_url
        self.press("ON is false")
        self.press("OFF is false")
        browser.eventually(lambda: "violate the constraint !(ON && OFF)" in " ".join(self.page.texts("#simulation .warning")))
        self.page.script("page.simulator.move('NOBODY = true')")
        browser.eventually(lambda: "unknown input NOBODY" in " ".join(self.page.texts("#simulation .problem")))
        self.page.wait_for_text("#simulation p", "5 moves")
        self.press("Back")
        self.page.wait_for_text("#simulation p", "4 moves")
        self.press("Restart")
        self.page.wait_for_text("#simulation p", "0 moves")
        self.page.open("about:blank")
        self.page.open(address)
        self.page.wait_for_text("#simulation p", "3 s since power-on, 3 moves")
        self.press("Random")
        self.page.wait_for_text("#simulation p", "23 moves")
        self.page.find("#simulation .trace").click()
        self.page.press(browser.Keys.HOME)
        self.assertEqual(self.page.texts("tr[aria-selected=true] td")[1], "lamp: power on")
        self.page.press(browser.Keys.ARROW_DOWN)
        self.assertEqual(self.page.script("return page.simulator.cursor"), 1)

    def test_a_step_forced_for_trial_is_not_shown_as_a_run_of_the_model(self):
        self.serve(LAMP)
        self.page.find("#simulation .force summary").click()
        choose = lambda step: self.page.script("const s = page.simulator.step; s.value = arguments[0]; s.dispatchEvent(new Event('change'))", step)
        trial = lambda: self.page.script("return page.simulator.trial.textContent")
        self.assertEqual(trial(), "")
        choose("1")
        self.press("Activate")
        self.page.wait_for("#c0-step-1.active .token")
        self.page.wait_for("#c0-step-0.active .token")
        self.assertIn("not a run of the model", trial())
        choose("0")
        self.press("Deactivate")
        self.assertEqual(self.last_row()[3], "1")
        words = self.page.texts("#simulation tbody tr.trial td:nth-child(2)")
        self.assertEqual(words[0], "WHAT-IF: step 1 was forced active; the trace is no longer a run of the model")
        times = self.page.texts("#simulation tbody td:first-child")
        self.assertFalse(times[0].startswith("trial"))
        self.assertTrue(times[-1].startswith("trial"))
        self.press("Next")
        self.assertEqual(self.last_row()[3], "0")
        self.assertEqual(self.page.script(browser.UNNAMED), [])
        self.page.screenshot("serve-trial")
        address = self.page.driver.current_url
        script = self.work / "trial.txt"
        script.write_text(self.page.script("return page.simulator.script()"))
        self.assertIn("// What-if run", script.read_text())
        said = browser.run("simulate", self.file, "--chart", "lamp", "--script", script)
        self.assertIn("WHAT-IF: step 0 was forced", said)
        self.page.open("about:blank")
        self.page.open(address)
        self.page.wait_for_text("#simulation p", "3 s since power-on, 3 moves")
        self.assertIn("not a run of the model", trial())
        self.page.find("#simulation .force summary").click()
        choose("1")
        self.press("Activate")
        for _ in range(4):
            self.press("Back")
        self.assertEqual(trial(), "")

    def test_every_evolution_can_be_stepped_through(self):
        self.serve(LAMP)
        self.press("ON is false")
        rows = len(self.page.all("#simulation tbody tr"))
        self.page.find("#simulation .check input").click()
        browser.eventually(lambda: len(self.page.all("#simulation tbody tr")) > rows, what="more rows")
        self.assertIn("#every=", self.page.driver.current_url)

    def test_moves_stay_where_the_file_changes(self):
        self.serve(LAMP)
        self.press("ON is false")
        self.wait_for_row("LAMP")
        self.file.write_text(LAMP.replace("LAMP", "BULB"))
        self.wait_for_row("BULB")

    def test_moves_that_a_passing_save_does_not_allow_can_be_replayed(self):
        self.serve(LAMP)
        self.press("ON is false")
        self.press("ON is true")
        self.file.write_text(re.sub(r"\bON\b", "IN", LAMP))
        self.page.wait_for_text("#simulation p", "0 moves")
        self.file.write_text(LAMP)
        browser.eventually(lambda: "ON is false" in self.page.texts("#simulation button"), what="the input")
        self.press("Again")
        self.press("Again")
        self.page.wait_for_text("#simulation p", "2 moves")

    def test_hostile_texts_are_texts(self):
        hostile = "<img src=x onerror=alert(1)> \\u202e </pre><script>shout()</script>"
        self.serve(LAMP + "closed_loop l { controller lamp with stability_search; environment A = free(OUT = ON); environment B = free(OUT = OFF);\n"
                   "environment C = free_integer(OUT = N, HIGH = 9);\n"
                   f'property P "{hostile}": reachable LAMP; }}\n')
        browser.eventually(lambda: "onerror" in " ".join(self.page.texts("#models p")), what="the prose")
        self.assertEqual(self.page.all("#models img") + self.page.all("#models script"), [])
        self.file.write_text(LAMP + "<script>alert(1)</script>")
        self.page.wait_for_text("#diagnostics-text", "<script>")
        self.assertEqual(len(self.page.all("body script")), 0)

    def test_it_can_be_read_at_every_size_in_both_schemes_and_by_a_screen_reader(self):
        self.serve(LAMP)
        self.press("ON is false")
        self.wait_for_row("LAMP")
        browser.eventually(lambda: "as expected" in self.page.text("#status"), what="the verdicts")
        for size in browser.SIZES:
            for scheme in browser.SCHEMES:
                self.page.size(size)
                self.page.scheme(scheme)
                self.page.screenshot(f"serve-{size}-{scheme}")
                with self.subTest(size=size, scheme=scheme):
                    self.assertEqual(self.page.script(browser.FAINT_TEXTS), [])
                    self.assertEqual(self.page.script(browser.UNNAMED), [])
                    self.assertLessEqual(self.page.script(browser.EXCESS_WIDTH), 0)

    def test_enabled_transitions_and_active_actions_are_lit_and_the_view_follows(self):
        steps = range(1, 30)
        self.serve("grafcet long { input ON; output LAMP; initial step 0 { LAMP; }\n" +
                   "".join(f"step {k};\ntransition t{k}: {k - 1} -> {k} when ON;\n" for k in steps) +
                   "transition t30: 29 -> 0 when !ON; }\n")
        self.page.wait_for("#c0-step-0.active .token")
        lit = lambda selector: self.page.script("return [...document.querySelectorAll(arguments[0])].map(e => e.id)", selector)
        self.assertEqual(lit(".transition.enabled, .condition.enabled"), ["c0-transition-t1", "c0-condition-t1"])
        self.assertEqual(lit(".action.active"), ["c0-action-c0"])
        self.press("ON is false")
        self.page.wait_for("#c0-step-29.active .token")
        self.assertEqual(lit(".transition.enabled"), ["c0-transition-t30"])
        self.assertEqual(lit(".action.active"), [])
        outside = """const step = document.getElementById('c0-step-29').getBoundingClientRect(),
                     view = document.querySelector('.drawing').getBoundingClientRect();
                     return step.top < view.top || step.bottom > view.bottom"""
        self.assertFalse(self.page.script(outside))

    def test_unexpected_verdicts_come_first_and_warnings_do_not_count_as_errors(self):
        self.serve("grafcet lamp { input ON; output LAMP; initial step 0; step 1 { LAMP; } step 7;\n"
                   "transition on: 0 -> 1 when ON; transition off: 1 -> 0 when !ON; }\n"
                   "closed_loop l { controller lamp with stability_search; environment A = push_button(OUT = ON);\n"
                   "property HOLDS: never X1 && X0; property EXPECTED expected violated: never LAMP; property BAD: never X1; }\n")
        browser.eventually(lambda: "not as expected" in self.page.text("#status"), what="the verdicts")
        names = self.page.texts(".property strong")
        self.assertEqual(names[:3], ["BAD", "EXPECTED", "HOLDS"])
        self.assertEqual(self.page.text("#diagnostics-title"), "Warnings")
        self.assertFalse(self.page.all("#diagnostics.errors"))
        self.file.write_text("grafcet")
        self.page.wait_for_text("#diagnostics-title", "Errors")
        self.assertTrue(self.page.all("#diagnostics.errors"))

    def test_operator_inputs_are_apart_from_sensors(self):
        self.serve(OVEN.read_text())
        self.page.wait_for("#inputs button")
        environment = set(self.page.script("return page.simulator.answer.signals.filter(s => s.role === 'input' && s.by === 'environment').map(s => s.name)"))
        shown = lambda place: {words.split()[0] for words in self.page.texts(f"#{place} button")}
        self.assertIn("START", environment)
        self.assertEqual(shown("inputs"), environment)
        self.assertTrue(shown("sensors"))
        self.assertFalse(shown("inputs") & shown("sensors"))

    def test_a_server_that_has_ended_is_reported(self):
        server = self.serve(LAMP)
        server.stop()
        self.page.wait_for_text("#status", "does not respond")
        self.allowed_errors = ("ERR_CONNECTION", "Failed to load resource")


if __name__ == "__main__":
    browser.main()
