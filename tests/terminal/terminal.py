# SPDX-License-Identifier: MIT
"""Runs the program at a pseudo-terminal: sends single keys and reads the screen output."""
import os
import pty
import re
import select
import signal
import termios
import time

PROGRAM = os.environ["GRAFVERIF_PROGRAM"]
CONTROL = re.compile(r"\x1b(\[[0-9;?]*[A-Za-z]|[=>()][0-9A-B]?)|\x07|\r")


class Terminal:
    """A run of the program whose standard streams are a terminal."""

    def __init__(self, *arguments, folder, **variables):
        self.child, self.screen = pty.fork()
        if self.child == 0:
            os.chdir(folder)
            environment = {**os.environ, "TERM": "xterm", "HOME": folder, "LC_ALL": "C.UTF-8", "NO_COLOR": "1", **variables}
            os.execve(PROGRAM, [PROGRAM, *arguments], environment)
        self.before = termios.tcgetattr(self.screen)
        self.text = ""

    def await_text(self, wanted, patience=60):
        """Waits until `wanted` appears after the previously awaited text; returns the output up to it."""
        end = time.monotonic() + patience
        while wanted not in self.text:
            if not select.select([self.screen], [], [], max(0, end - time.monotonic()))[0]:
                raise AssertionError(f"no {wanted!r} in {self.text!r}")
            try:
                sent = os.read(self.screen, 65536)
            except OSError:
                sent = b""
            if not sent:
                raise AssertionError(f"it ended without {wanted!r}: {self.text!r}")
            self.text = CONTROL.sub("", self.text + sent.decode(errors="replace"))
        place = self.text.index(wanted) + len(wanted)
        shown, self.text = self.text[:place], self.text[place:]
        return shown

    def type(self, keys):
        os.write(self.screen, keys.encode())

    def send(self, number):
        os.kill(self.child, number)

    def end(self, patience=60):
        """Returns the exit code, and True if the terminal settings are restored."""
        deadline = time.monotonic() + patience
        while True:
            try:  # read pending output, because the program may wait for it
                if select.select([self.screen], [], [], 0.05)[0]:
                    self.text += os.read(self.screen, 65536).decode(errors="replace")
            except OSError:
                pass
            done, status = os.waitpid(self.child, os.WNOHANG)
            if done:
                break
            if time.monotonic() > deadline:
                self.send(signal.SIGKILL)
                raise AssertionError(f"it does not end: {self.text!r}")
        same = termios.tcgetattr(self.screen)[3] == self.before[3]
        os.close(self.screen)
        return os.waitstatus_to_exitcode(status), same
