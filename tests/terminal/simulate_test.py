# SPDX-License-Identifier: MIT
"""Tests `simulate` at a terminal: line editing, history, word completion, and saving of a session."""
import os
import shutil
import signal
import subprocess
import tempfile
import unittest

from terminal import PROGRAM, Terminal

SAMPLES = os.path.join(os.path.dirname(__file__), "../../samples")
UP, LEFT, CTRL_A, CTRL_C, CTRL_D, CTRL_R, BACKSPACE = "\x1b[A", "\x1b[D", "\x01", "\x03", "\x04", "\x12", "\x7f"


class Simulate(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="grafverif-terminal-")
        self.addCleanup(shutil.rmtree, self.folder)
        shutil.copy(os.path.join(SAMPLES, "blinker/blinker.grafcet"), self.folder)

    def begin(self, *options, **variables):
        terminal = Terminal("simulate", "blinker.grafcet", *options, folder=self.folder, **variables)
        terminal.await_text("> ")
        return terminal

    def test_a_line_is_edited_and_the_ones_before_come_back(self):
        terminal = self.begin()
        terminal.type("ait 1s" + CTRL_A + "w\r")
        terminal.await_text("1 s passes")
        terminal.await_text("> ")
        terminal.type("wait 7x" + BACKSPACE + "s" + LEFT + BACKSPACE + "2\r")
        terminal.await_text("2 s pass")
        terminal.await_text("> ")
        terminal.type(UP + UP + "\r")
        terminal.await_text("1 s passes")
        terminal.await_text("> ")
        terminal.type(CTRL_R + "2s\r")
        terminal.await_text("2 s pass")
        terminal.await_text("> ")
        terminal.type(CTRL_D)
        self.assertEqual(terminal.end(), (0, True))

    def test_tab_completes_commands_and_names_and_lists_what_there_is(self):
        terminal = self.begin()
        terminal.type("wa\t1s\r")
        terminal.await_text("1 s passes")
        terminal.await_text("> ")
        terminal.type("BU\t= tr\t\r")
        terminal.await_text("blinker")
        terminal.await_text("> ")
        terminal.type("do \t")
        self.assertIn("Button", terminal.await_text("Lamp"))
        terminal.type("La\tlit\r")
        terminal.await_text("! `Lamp` cannot move to `lit` now")
        terminal.await_text("> ")
        terminal.type("expect LA\t\r")
        terminal.await_text("> ")
        terminal.type("expect X\t")
        terminal.await_text("X2")
        terminal.type(CTRL_C)
        terminal.await_text("> ")
        terminal.type("quit\r")
        self.assertEqual(terminal.end(), (0, True))

    def test_ctrl_c_discards_only_the_line(self):
        terminal = self.begin()
        terminal.type("wait 99999h" + CTRL_C)
        terminal.await_text("^C")
        terminal.await_text("> ")
        terminal.type("show\r")
        terminal.await_text("time       0 s")
        terminal.await_text("> ")
        terminal.type("quit\r")
        self.assertEqual(terminal.end(), (0, True))

    def test_a_signal_ends_it_and_the_terminal_is_as_it_was(self):
        for number in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT):
            terminal = self.begin()
            terminal.type("wai")
            terminal.await_text("wai")
            terminal.send(number)
            code, same = terminal.end()
            self.assertIn(code, (3, -number))
            self.assertTrue(same)

    def test_a_session_is_saved_as_a_script_that_expects_what_was_seen(self):
        terminal = self.begin()
        for line in ("wait 1s", "BUTTON = true", "wait 5min", "undo", "wait 2s", "nonsense", "expect X2", "expect X0"):
            terminal.type(line + "\r")
            terminal.await_text("> ")
        terminal.type("save blinker.grafcet\r")
        terminal.await_text("! `blinker.grafcet` exists and is not a saved session")
        terminal.await_text("> ")
        for name in ("session.txt", "session.txt"):
            terminal.type(f"save {name}\r")
            terminal.await_text("saved; replay the session with `--script session.txt`")
            terminal.await_text("> ")
        terminal.type("save no/such/folder/session.txt\r")
        terminal.await_text("! folder `no/such/folder` does not exist; create it or choose another one")
        terminal.await_text("> ")
        terminal.type(CTRL_D)
        self.assertEqual(terminal.end(), (0, True))
        with open(os.path.join(self.folder, "session.txt"), encoding="utf-8") as saved:
            self.assertEqual(saved.read().splitlines()[1:],
                             ["wait 1s", "BUTTON = true", "expect X1, not X0, LAMP", "wait 2s",
                              "expect X2, not X1, not LAMP", "expect X2"])
        again = subprocess.run([PROGRAM, "simulate", "blinker.grafcet", "--script", "session.txt"], cwd=self.folder,
                               capture_output=True, text=True, timeout=100)
        self.assertEqual((again.returncode, again.stderr), (0, ""))

    def test_a_home_that_is_not_there_and_a_terminal_that_knows_lines_alone_change_nothing(self):
        terminal = self.begin(HOME="/proc/no/such/home")
        terminal.type("quit\r")
        self.assertEqual(terminal.end(), (0, True))
        terminal = self.begin(TERM="dumb")
        terminal.type("wait 1s\n")
        terminal.await_text("1 s passes")
        terminal.await_text("> ")
        terminal.type(CTRL_D)
        self.assertEqual(terminal.end(), (0, True))


if __name__ == "__main__":
    unittest.main()
