"""The first process in the box (box.sh): serves the built page, and does with the serial port what the rig says.

    box.py RUN SITE POLICY

RUN is the folder whose parts stand for parts of the machine here, SITE holds the built page, POLICY lets it use serial ports
unasked. One JSON object a line. In, on standard input, whose end is the end of the box:
    {"do": "grant"}                     puts the policy in force; before Chromium starts
    {"do": "plug", "number": 0}         as ttyUSB0
    {"do": "unplug"}
    {"do": "hangup"}                    the port fails as with a broken adapter: nothing tells that it has gone
    {"do": "mend"}                      it works again, and nothing tells that either
    {"do": "hold"}, {"do": "release"}   another program has the port open
    {"do": "break"}, {"do": "parity"}   the page receives a break, a byte of wrong parity
    {"do": "send", "hex": "00 0f"}      bytes to the page
Out: each of these, when it is done, as {"is": "plug"}, but for "send"; and
    {"is": "ready"}
    {"is": "opened"}, {"is": "closed"}  by the page, which has said something: Firefox tries ports in silence, too
    {"is": "set", "baudRate": 9600, "stopBits": 1, "flowControl": "none"}   before the first bytes, and when it changes
    {"is": "data", "hex": "00 0f"}      bytes from the page
"""

import fcntl
import http.server
import json
import os
import selectors
import shutil
import socket
import struct
import sys
import threading

from port import Port
from udev import Adapter

ADDRESS = ("127.0.0.1", 4173)
# What a driver makes of them for a reader that wants marks (PARMRK).
MARKS = {"break": b"\xff\0\0", "parity": b"\xff\0A"}


class Desk:
    def __init__(self, run, policy):
        self.run, self.policy = run, policy
        self.adapter = Adapter(run)
        self.selector = selectors.DefaultSelector()
        self.port = None
        self.rest = b""
        self.selector.register(sys.stdin, selectors.EVENT_READ, self._read)

    def work(self):
        self._say("ready")
        while True:
            for key, events in self.selector.select():
                if key.fd in self.selector.get_map():  # else it has been taken away by what came before it
                    key.data(events)

    def _say(self, what, **more):
        print(json.dumps({"is": what, **more}), flush=True)

    def _read(self, _):
        data = os.read(sys.stdin.fileno(), 65536)
        if not data:
            sys.exit()
        *lines, self.rest = (self.rest + data).split(b"\n")
        for line in lines:
            order = json.loads(line)
            what = order.pop("do")
            if what in MARKS:
                self.port.damage(MARKS[what])
            else:
                getattr(self, what)(**order)
            if what != "send":
                self._say(what)

    def grant(self):
        shutil.copy(self.policy, f"{self.run}/chromium/policies/managed/")

    def plug(self, number):
        self.adapter.name_it(number)
        self.mend()
        self.adapter.appear()

    def unplug(self):
        if self.port:
            self.hangup()
        self.adapter.disappear()

    def hangup(self):
        self.port.remove()
        self.port = None

    def mend(self):
        self.port = Port(self.adapter.node, self.selector, self._say)

    def hold(self):
        self.port.hold(True)

    def release(self):
        self.port.hold(False)

    def send(self, hex):
        if self.port:
            self.port.send(bytes.fromhex(hex))


class Site(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


def raise_loopback():
    """A new network namespace has a loopback device, but it is down."""
    set_flags, up = 0x8914, 1
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as any_socket:
        fcntl.ioctl(any_socket, set_flags, struct.pack("16sh14x", b"lo", up))


def main(run, site, policy):
    try:
        raise_loopback()
        server = http.server.ThreadingHTTPServer(ADDRESS, lambda *args: Site(*args, directory=site))
        threading.Thread(target=server.serve_forever, daemon=True).start()
        Desk(run, policy).work()
    finally:
        shutil.rmtree(run, ignore_errors=True)


main(*sys.argv[1:])
