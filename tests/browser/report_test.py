# SPDX-License-Identifier: MIT
"""Tests the page of `report` in a browser: presses keys, opens addresses and expands conditions."""
import browser
from browser import Keys, eventually

FAULTY = browser.SOURCE / "samples/testing_station/faulty.grafcet"
PRESSED = browser.SOURCE / "docs/blinker_pressed.grafcet"
HOSTILE = """
grafcet press {
    input START;
    output MOTOR;
    initial step 0;
    step 1 { MOTOR; }
    transition T0: 0 -> 1 when rise(START);
    transition T1: 1 -> 0 when 2s/X1 && !START;
    accept step-reactivated "</script><script>document.title = 'taken'</script>";
}
closed_loop shop {
    controller press;
    environment Start = free(OUT = START);
    property idle "</script><img src=x onerror=document.title='taken'> ' & \u202e": never MOTOR;
}
"""
STEPWISE = """
grafcet g {
    input A;
    output L;
    initial step 0;
    step 1;
    step 2 { L; }
    step 3;
    transition t0: 0 -> 1 when A;
    transition t1: 1 -> 2 when A;
    transition t2: 1 -> 3 when !A;
}
closed_loop l {
    controller g with every_cycle;
    environment Button = free(OUT = A);
    property p: never X3;
}
"""
SETTLED = """
grafcet g {
    input A;
    output L;
    initial step 0;
    step 1;
    step 2;
    step 3 { L; }
    transition t0: 0 -> 1 when A;
    transition t1: 1 -> 2 when true;
    transition t2: 2 -> 3 when !A;
    transition t3: 3 -> 0 when A;
}
closed_loop l {
    controller g with stability_search;
    environment Button = push_button(OUT = A, GAP = 1s);
    property p: never X1 || X3 at stable;
    property q: X2 leads to X1 at stable;
}
"""
DELAYED = """
grafcet g {
    input A, B;
    output L;
    initial step 0;
    step 1 { L; }
    step 2;
    transition t0: 0 -> 1 when A;
    transition t1: 1 -> 2 when 2s/X1 && !B;
    transition t2: 2 -> 0 when rise(B);
}
closed_loop l {
    controller g with stability_search;
    environment X = free(OUT = A);
    environment Y = free(OUT = B);
    property q: never X2 && B;
}
"""
TWICE = """
grafcet g {
    input A, B;
    output L;
    internal N: int 0..3 = 0;
    initial step 0;
    step 1;
    step 2 { L; N := N + 1 on activation; }
    transition t0: 0 -> 1 when rise(A) || B && N > 0;
    transition t1: 1 -> 2 when true;
    transition t2: 2 -> 0 when !A && N < 2;
}
closed_loop l {
    controller g with stability_search;
    environment X = free(OUT = A);
    environment Y = free(OUT = B);
    property p: never N == 2 at stable;
}
"""
CROSSING = """
grafcet traffic_light {
    input REQ;
    output C_GREEN, C_YELLOW, C_RED, P_GREEN;
    initial step 1 { C_GREEN; }
    step 2 { C_YELLOW; }
    step 3 { C_RED; }
    step 4 { C_RED; P_GREEN; }
    transition t1: 1 -> 2 when REQ && 30s/X1;
    transition t2: 2 -> 3 when 3s/X2;
    transition t3: 3 -> 4 when 2s/X3;
    transition t4: 4 -> 1 when 15s/X4;
}
closed_loop crossing {
    controller traffic_light;
    environment Button = push_button_released(OUT = REQ, HOLD = 2s);
    property served "each request is served within 31 s": REQ leads to P_GREEN within 31s;
    property once: P_GREEN at most 1 time;
    property between: never C_YELLOW between REQ and P_GREEN;
    property comes: inevitable P_GREEN after REQ;
    property often: C_GREEN at least every 10s after P_GREEN;
    property walks: P_GREEN holds for 16s;
    property short: C_YELLOW holds at most 2s;
    property first: C_RED precedes C_YELLOW;
    property holds: never C_GREEN && P_GREEN;
}
"""
WIDE = """return [...document.querySelectorAll('body *')].filter(e => e.getBoundingClientRect().right > innerWidth + 1)
          .map(e => e.tagName + '.' + e.className).slice(0, 9)"""
LIT = ".chart-view .step.active"


class Report(browser.Case):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.made = cls.folder / "report.html"
        browser.run("report", FAULTY, "--property", "P15", "--property", "P16", "--timeout", "20s", "-o", cls.made, code=0)

    def at(self, address):
        self.page.open("about:blank")
        self.page.open(self.made.resolve().as_uri() + address)
        self.page.wait_for(".player")

    def report_of(self, text, *options):
        """Returns a function that opens addresses of a report of the chart `text`."""
        source, made = self.work / "chart.grafcet", self.work / "chart.html"
        source.write_text(text)
        browser.run("report", source, *options, "-o", made, code=None)
        def at(address):
            self.page.open("about:blank")
            self.page.open(made.resolve().as_uri() + address)
            self.page.wait_for(".player")
        return at

    def answer(self, transition):
        """Returns the displayed reason why `transition` is cleared or not, with the values of its terms."""
        self.page.script("""const s = document.querySelector('.pick select');
                            s.value = [...s.options].find(o => o.text === arguments[0]).value;
                            s.dispatchEvent(new Event('change'))""", transition)
        return self.page.text(".pick + .why")

    def lit(self):
        return self.page.script(f"return [...document.querySelectorAll('{LIT}')].map(e => e.dataset.element)")

    def place(self):
        return self.page.script("return location.hash")

    def test_it_says_at_a_glance_what_holds(self):
        self.page.open(self.made)
        self.assertIn("Every verdict selected is as expected", self.page.text(".glance"))
        self.assertIn("cycle takes no time", self.page.text(".assumed"))
        self.assertTrue(self.page.find("#property-P16").get_attribute("open"))
        self.assertFalse(self.page.find("#property-P15").get_attribute("open"))

    def test_the_counterexample_is_played_to_its_end_by_keys(self):
        self.at("#P16/0")
        self.assertEqual(sorted(self.lit()), ["step-0", "step-watchdog_in-W5", "step-watchdog_out-W0"])
        self.page.find(".chart-view").send_keys(Keys.END)
        eventually(lambda: self.place() == "#P16/138", what="the end")
        self.assertEqual(sorted(self.lit()), ["step-0", "step-watchdog_in-W5", "step-watchdog_out-W0"])
        self.page.press(Keys.ARROW_LEFT, Keys.ARROW_LEFT)
        self.assertIn("step-12", self.lit())
        self.page.press(Keys.ARROW_RIGHT)
        self.assertIn("T12", self.page.text(".caption"))
        cleared = self.page.script("return [...document.querySelectorAll('.chart-view .transition.cleared')].map(e => e.dataset.element)")
        self.assertEqual(cleared, ["transition-T12"])
        self.assertTrue(self.page.all(".chart-view .transition.cleared .tick"), "not by colour alone")
        self.assertTrue(self.page.all(f"{LIT} .token"), "not by colour alone")
        self.page.press(Keys.HOME)
        self.assertEqual(self.place(), "#P16/0")

    def test_an_address_leads_to_its_moment(self):
        self.at("#P16/23")
        self.assertEqual(self.page.script("return page.player.run.address(page.player.moment)"), "23")
        before = self.page.text(".place")
        self.page.script("location.hash = '#P16/40'")
        eventually(lambda: self.page.text(".place") != before)
        self.assertEqual(self.page.script("return page.player.run.address(page.player.moment)"), "40")
        self.at("#P16/99999999")
        rows = self.page.script("return page.player.run.shown.length")
        self.assertIn(f"row {rows} of {rows}", self.page.text(".place"))
        self.at("#nobody/3")
        self.assertTrue(self.lit(), "it begins somewhere")

    def test_the_counter_is_the_position_in_the_list_of_events(self):
        """The counter numbers the rows of the table of `check`, also if several delays are merged into one row."""
        self.report_of(PRESSED.read_text())("#answered/0")
        printed = browser.run("check", PRESSED, code=1).split("counterexample:\n")[1].split("    * causes")[0].splitlines()
        rows = len([line for line in printed[1:] if not line.startswith("+--")])
        self.assertLess(rows, self.page.script("return page.player.run.rows.length"), "some rows are merged")
        for row in range(1, rows + 1):
            self.assertEqual(self.page.text(".place").split(" · ")[0], f"row {row} of {rows}")
            self.assertEqual(self.page.find(".rows .row.current").get_attribute("aria-posinset"), str(row))
            self.page.press(Keys.ARROW_RIGHT)
        self.page.find(".tools input[type=checkbox]").click()
        counted = self.page.script("""return page.player.run.times.map((_, moment) => {
            page.player.go(moment);
            return [document.querySelector('.place').textContent.split(' · ')[0], page.player.rows.current];
        })""")
        self.assertEqual({words for words, _ in counted}, {f"row {row} of {rows}" for row in range(1, rows + 1)}, "with every move")
        self.assertEqual([words for words, _ in counted], [f"row {current + 1} of {rows}" for _, current in counted])

    def test_the_false_term_of_a_condition_is_pointed_at(self):
        self.at("#P16/131")
        picker = self.page.find(".pick select")
        self.page.script("""const s = arguments[0]; s.value = [...s.options].find(o => o.text === 'T12').value;
                            s.dispatchEvent(new Event('change'))""", picker)
        self.assertIn("T12 is enabled, but its condition is false", self.page.text(".pick + .why .answer"))
        self.assertIn("H_IN", " ".join(self.page.texts(".pick + .why .term.false")))
        self.page.script("""const s = arguments[0]; s.value = [...s.options].find(o => o.text === 'TW2').value;
                            s.dispatchEvent(new Event('change'))""", picker)
        self.assertIn("is not active", self.page.text(".pick + .why .answer"))

    def test_every_cleared_transition_was_enabled_and_its_condition_true(self):
        self.at("#P16/0")
        wrong = self.page.script("""
            const player = window.page.player, run = player.run, faults = [];
            let seen = 0;
            for (let m = 1; m <= run.last; ++m)
                for (const act of run.trace.moments[m].acts) {
                    if (!act.does.includes("evolve")) continue;
                    const chart = player.chartOf(act.controller), reader = new Decision(run, chart, act.controller, m, true);
                    chart.transitions.forEach((transition, place) => {
                        const id = run.controllers[act.controller].transitions[place];
                        const enabled = transition.from.every(s => run.isActive(run.controllers[act.controller].steps[s], m - 1));
                        const fires = enabled && reader.value(transition.condition) === 1;
                        ++seen;
                        if (fires !== act.fired.includes(id)) faults.push(`${transition.name} at ${m}`);
                    });
                }
            return [seen, faults];
        """.replace("new Decision", "new window.page.Decision"))
        self.assertGreater(wrong[0], 500)
        self.assertEqual(wrong[1], [])

    def test_the_decisive_moment_of_a_claim_is_found(self):
        self.at("")
        [button] = [b for b in self.page.all(".controls button") if "violation" in b.text]
        self.page.find(".chart-view").send_keys(Keys.HOME)
        button.click()
        claim = self.page.texts(".why .term.true")
        self.assertIn("V_S", " ".join(claim))

    def test_a_clearing_is_predicted_only_after_inputs_are_read(self):
        at = self.report_of(STEPWISE)
        at("#p/1")
        self.assertIn("t0 is enabled; its condition is true for the current inputs", self.answer("t0"))
        at("#p/2")
        self.assertIn("the next evolution clears it", self.answer("t0"))
        at("#p/4")  # A is sampled again and is now false
        self.assertIn("t1 is enabled; its condition is true for the inputs last read", self.answer("t1"))

    def test_transient_states_do_not_decide_a_property_at_stable(self):
        at = self.report_of(SETTLED)
        at("#p/0")
        self.assertIn("forbidden in quiescent states", self.page.text(".why .answer"))
        [button] = [b for b in self.page.all(".controls button") if "violation" in b.text]
        button.click()
        self.assertEqual(self.place(), "#p/6")
        self.assertEqual(self.lit(), ["step-3"])
        at("#q/0")
        self.assertIn("premise in quiescent states", self.page.text(".why .answer"))
        self.assertEqual([b.text for b in self.page.all(".controls button") if "violation" in b.text], [])

    def test_a_delay_that_began_since_timers_were_read_is_not_known(self):
        at = self.report_of(DELAYED, "--untimed")
        at("#q/1")
        self.assertIn("the trace does not determine the value of its condition", self.answer("t1"))
        self.assertIn("2s/X1 not known (not read since the timer started)", self.answer("t1"))
        at("#q/4")
        self.assertIn("t1 is cleared here", self.answer("t1"))
        self.assertIn("2s/X1 true", self.answer("t1"))

    def test_a_delay_that_is_over_since_timers_were_read_says_so(self):
        at = self.report_of(DELAYED)
        at("#q/4")
        self.assertIn("2s/X1 false (read at 0 s; it is now true; X1 has been active for 2 s)", self.answer("t1"))

    def test_a_transition_that_is_cleared_twice_says_so(self):
        at = self.report_of(TWICE)
        at("#p/5")
        self.assertIn("t0 is cleared 2 times here. The tree shows the condition of t0 before it was cleared for the last time.", self.answer("t0"))
        self.assertIn("t2 is cleared here", self.answer("t2"))

    def test_a_false_forbidden_term_is_not_marked_as_a_fault(self):
        at = self.report_of(STEPWISE)
        at("#p/0")
        self.assertEqual(self.page.text(".why .answer"), "forbidden: false since power-on")
        self.assertEqual(self.page.script("return window.page.player.claim.querySelectorAll('.term.false').length"), 0)

    def test_a_row_is_not_announced_before_it_has_ended(self):
        at = self.report_of(SETTLED)
        at("#p/0+1")
        self.assertEqual(self.page.text(".caption"), "0 s: a cycle begins.")

    def test_moves_inside_a_cycle_are_stepped_one_by_one(self):
        self.at("#P16/136")
        self.page.script("document.querySelector('.tools input[type=checkbox]').click()")
        self.page.find(".chart-view").send_keys(Keys.ARROW_RIGHT)
        eventually(lambda: self.place() == "#P16/136+1")
        self.assertIn("a cycle begins", self.page.text(".caption"))

    def test_signals_are_filtered(self):
        self.at("#P16/10")
        self.page.find(".filters input[type=search]").send_keys("V_G")
        self.assertEqual(sorted(self.page.texts(".signals tbody th")), ["V_G_IN", "V_G_OUT"])

    def test_it_can_be_read_at_every_size_in_both_schemes_and_by_a_screen_reader(self):
        for size in browser.SIZES:
            self.page.size(size)
            for scheme in browser.SCHEMES:
                self.page.scheme(scheme)
                self.at("#P16/131")
                self.page.screenshot(f"report-{size}-{scheme}")
                self.assertLessEqual(self.page.script(browser.EXCESS_WIDTH), 0, f"{size}: {self.page.script(WIDE)}")
                self.assertEqual(self.page.script(browser.FAINT_TEXTS), [], f"{size}, {scheme}")
                self.assertEqual(self.page.script(browser.UNNAMED), [], size)

    def test_it_is_printed(self):
        self.at("#P16/131")
        self.assertGreater(len(self.page.pdf()), 30000)

    def test_a_sentence_with_a_duration_or_a_scope_is_explained_event_by_event(self):
        at = self.report_of(CROSSING)
        for name in ("served", "once", "between", "comes", "often", "walks", "short", "first"):
            with self.subTest(name):
                at(f"#{name}/0")
                headings = self.page.script("return [...page.player.claim.querySelectorAll('.answer')].map(e => e.textContent)")
                self.assertTrue(headings)
                self.assertFalse([each for each in headings if each.startswith(":")])
                self.assertTrue(self.page.text(".violation"))
                [button] = [b for b in self.page.all(".controls button") if "violation" in b.text]
                button.click()
                self.assertIn("violated here", self.page.text(".standing"))
                self.assertNotIn("observer", self.page.text(".signals"))
                self.page.find(".player").send_keys(Keys.END)
                self.assertEqual(self.page.script("return page.player.run.trace.moments.filter(m => m.kind === 'observer').length"), 0)
                self.assertNotIn("+", self.page.text(".place"), "the last row is the last moment")
        at("#served/0")
        asked = self.page.script("const {run} = page.player; return run.timeText(run.data.violation.steps[0].moment)")
        due = int(asked.split()[0]) + 31
        self.assertEqual(self.page.text(".violation"), f"REQ at {asked}; deadline {due} s; P_GREEN not true by then.")
        self.page.find(".violation button").click()
        self.assertIn(f"{asked}: Button: pressed \u2014 REQ := true", self.page.text(".caption"))

    def test_arrow_keys_move_a_player_in_sight_without_a_click(self):
        at = self.report_of(CROSSING)
        at("")
        self.page.script("document.activeElement.blur(); scrollTo(0, 0)")
        before = self.page.script("return page.player.moment")
        below = self.page.script("return page.player.element.getBoundingClientRect().top >= innerHeight")
        if below:
            self.page.press(Keys.ARROW_RIGHT)
            self.assertEqual(self.page.script("return page.player.moment"), before, "it is out of sight")
        self.page.script("page.player.go(0); page.player.element.scrollIntoView()")
        self.page.press(Keys.ARROW_RIGHT)
        self.assertGreater(self.page.script("return page.player.moment"), 0)

    def test_timing_diagram_and_values_are_in_sight_beside_the_chart(self):
        at = self.report_of(CROSSING)
        self.page.size("laptop")
        at("#served/3")
        self.page.script("page.player.element.scrollIntoView()")
        for selector in (".chart-view", ".timing-view", ".signals"):
            with self.subTest(selector):
                self.assertLess(self.page.script("return document.querySelector(arguments[0]).getBoundingClientRect().top + 60 - innerHeight", selector), 0)

    def test_verdicts_are_aligned_with_and_without_prose(self):
        at = self.report_of(CROSSING)
        at("")
        edges = self.page.script("return [...document.querySelectorAll('.property .outcome')].map(e => Math.round(e.getBoundingClientRect().right))")
        self.assertGreater(len(edges), 5)
        self.assertEqual(len(set(edges)), 1, edges)

    def test_every_event_shows_since_when_the_terms_of_a_property_have_their_values(self):
        for name in ("P15", "P16"):
            self.at(f"#{name}/0")
            if self.page.script("return page.player.claims === null"):
                continue
            wrong = self.page.script("""
                const {claims, run} = page.player, {terms} = claims, wrong = [];
                const plain = {not: (v) => Number(!v[0]), and: (v) => Number(v.every(Boolean)), or: (v) => Number(v.some(Boolean))};
                const naive = (term, m) => {
                    const node = terms[term];
                    if (node.args) return plain[node.op](node.args.map((arg) => naive(arg, m)));
                    if (node.op === 'step') return Number(run.isActive(run.controllers[node.controller].steps[node.place], m));
                    const signal = node.op === 'signal' ? run.trace.signals.findIndex((s) => s.name === node.text)
                                                        : run.controllers[node.controller][node.op + 's'][node.place];
                    let value;
                    for (let k = 0; k <= m; ++k) for (const [s, v] of run.trace.moments[k].values) if (s === signal) value = v;
                    return value;
                };
                terms.forEach((node, term) => {
                    for (let m = 0; m <= run.last && wrong.length < 5; m += 7) {
                        const value = naive(term, m), since = claims.since(term, m);
                        if (claims.value(term, m) !== value) wrong.push(`${node.text} at ${m}: ${claims.value(term, m)}`);
                        if (since > m || naive(term, since) !== value || (since > 0 && naive(term, since - 1) === value))
                            wrong.push(`${node.text} at ${m}: since ${since}`);
                    }
                });
                return wrong;""")
            self.assertEqual(wrong, [], name)
        self.at("#P16/0")
        standing = lambda: self.page.text(".standing")
        self.assertIn("The premise without a response occurs at", standing())
        [button] = [b for b in self.page.all(".controls button") if "violation" in b.text]
        button.click()
        self.assertEqual(standing(), "The premise without a response occurs here.")
        self.assertIn("true since", self.page.text(".why .answer"))
        self.assertIn("caused by V_S = true", self.page.text(".why .answer"))
        self.page.find(".player").send_keys(Keys.END)
        self.assertIn("There has been no response since", standing())

    def test_what_decides_a_claim_is_a_state_of_the_model(self):
        at = self.report_of("""component toggle(output OUT) { initial location low; location high; urgent low -> high do OUT := true; urgent high -> low do OUT := false; }
            grafcet lamp { input ON; output L; initial step 0; step 1 { L; } step 2; step 3; transition a: 0 -> 1 when ON; transition b: 1 -> 2 when !ON;
            transition c: 2 -> 3 when ON; transition d: 3 -> 0 when ON && !ON; }
            closed_loop room { controller lamp with every_cycle; environment A = toggle(OUT = ON); property p: never X1 && ON || X3; }""",
            "--untimed", "--plant", "automata", "--schedule", "synchronous")
        at("#p/0")
        self.assertEqual(self.page.script("return page.player.claims.value(page.player.property.operands[0], 3)"), 1,
                         "the step is new, the input old: that is between two states")
        self.assertEqual(self.page.script("return page.player.decisive"), 8, "step 3 is active")

    def test_the_location_of_an_instance_is_lit_in_its_automaton(self):
        self.at("#P16/0")
        choose = lambda name: self.page.script("""const s = document.querySelector('select[aria-label=Instance]');
            s.value = [...s.options].find(o => o.text === arguments[0]).value; s.dispatchEvent(new Event('change'))""", name)
        names = lambda: self.page.script("""const svg = document.querySelector('.player .automaton svg');
            return [...svg.querySelectorAll('rect.node.active')].map(r => [...svg.querySelectorAll('text.name')].find(t => {
                const [b, c] = [r.getBBox(), t.getBBox()];
                return c.x >= b.x && c.y >= b.y && c.x < b.x + b.width && c.y < b.y + b.height; }).textContent)""")
        choose("V_Act")
        self.assertEqual(names(), ["still"])
        self.page.find(".player").click()
        moved = lambda: self.page.press(browser.Keys.ARROW_RIGHT) or names() == ["going_out"]
        browser.eventually(moved, what="the cylinder moves")
        self.assertIn("is in going_out", self.page.text(".player"))
        choose("V_Fault")
        self.assertEqual(names(), ["sound"])
        self.page.press(browser.Keys.END)
        self.assertEqual(names(), ["faulty"])
        self.page.screenshot("report-automaton")

    def test_hostile_names_are_shown_as_text(self):
        source, made = self.work / "hostile.grafcet", self.work / "hostile.html"
        source.write_text(HOSTILE, encoding="utf-8")
        browser.run("report", source, "-o", made, "--date", "<script>document.title='taken'</script>", code=None)
        self.page.open(made)
        self.page.wait_for(".player")
        self.assertNotEqual(self.page.script("return document.title"), "taken")
        self.assertIn("<img src=x", self.page.text("#property-idle"))
        self.assertEqual(len(self.page.all("script")), 2)
        self.assertEqual(self.page.all("img"), [])

    def test_a_long_run_scrolls(self):
        """In a table of almost 20,000 rows, only the visible rows exist in the page."""
        self.at("#P16/0")
        took = self.page.script("""
            const data = structuredClone(window.page.data.runs.find(r => r.name === 'P16'));
            const moments = data.run.moments, rows = data.rows, n = moments.length;
            for (let k = n; k < 20000; ++k) {
                moments.push({...moments[5], time: k * 1000, values: [[17, k % 7]]});
                rows.push({moment: k, words: `row ${k}`, cleared: "", shown: true});
            }
            data.name = "long";
            window.page.data.runs.push(data);
            const begin = performance.now();
            window.page.open("long");
            for (let k = 0; k < 100; ++k) window.page.player.go(n + k * 190);
            return performance.now() - begin;
        """)
        self.assertLess(len(self.page.all(".rows .row")), 60)
        self.assertLess(len(self.page.all(".timing-space *")), 6000)
        self.assertLess(took, 20000, "a hundred jumps")


if __name__ == "__main__":
    browser.main()
