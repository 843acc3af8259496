# SPDX-License-Identifier: MIT
"""Names what is being drawn: on a terminal in one line that is rewritten, elsewhere a line each; in a log with seconds."""
import sys
import time


class Progress:
    def __init__(self, log=None, stream=None):
        self.log, self.stream = log, stream or sys.stdout
        self.rewrites = self.stream.isatty()
        self.doing, self.since = "", 0.0

    def start(self, what):
        """Ends what was begun before and names what begins now."""
        self.end()
        self.doing, self.since = what, time.monotonic()
        self.stream.write(f"\r\033[K  {what}" if self.rewrites else f"  {what}\n")
        self.stream.flush()

    def end(self):
        if self.doing:
            self.note(f"{self.doing}: {time.monotonic() - self.since:.1f} s")
        if self.doing and self.rewrites:
            self.stream.write("\r\033[K")
        self.doing = ""

    def note(self, line):
        """For the log alone."""
        if self.log:
            self.log.write(line + "\n")
            self.log.flush()
