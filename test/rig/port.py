"""A pty behind the name of a serial port: who opens it, how it is set, and the bytes in both directions."""

import ctypes
import fcntl
import os
import selectors
import struct
import termios
import time
import tty


class Port:
    """`device` is the timer's end of the pty, `page` the end that the page opens; it is held open here too, so that it stays."""

    TCGETS2 = 0x802C542A

    def __init__(self, node, selector, say):
        self.node, self.selector, self.say = node, selector, say
        self.users = 0
        self.held = False
        self.settings = None  # until the page says something
        self.unsent = b""
        self.device, self.page = os.openpty()
        tty.setraw(self.page)
        os.set_blocking(self.device, False)
        path = os.ttyname(self.page)
        self.opens = Opens(path)
        os.symlink(path, node)
        selector.register(self.device, selectors.EVENT_READ, self._ready)
        selector.register(self.opens.fd, selectors.EVENT_READ, self._opened_or_closed)

    def remove(self):
        """Takes the port away: whoever has it open finds it dead. Chromium has taken what was sent before."""
        self._drain()
        for fd in (self.device, self.opens.fd):
            self.selector.unregister(fd)
        for fd in (self.device, self.page, self.opens.fd):
            os.close(fd)
        os.unlink(self.node)

    def send(self, data):
        if self.users > 0:  # What comes to a closed port is lost.
            self.unsent += data
            self._write()

    def damage(self, mark):
        """A pty damages nothing. But it lets the mark of a driver through, when told that nobody wants marks."""
        attributes = termios.tcgetattr(self.page)
        attributes[0] &= ~termios.PARMRK
        termios.tcsetattr(self.page, termios.TCSANOW, attributes)
        self.send(mark)

    def hold(self, held):
        """Shuts the port as another program does that has it open, or lets go of it."""
        self.held = held
        self._share()

    def _share(self):
        """Takes back Chromium's own claim to the port: a pty, which outlives its users, would keep it for ever."""
        fcntl.ioctl(self.page, termios.TIOCEXCL if self.held else termios.TIOCNXCL)

    def _opened_or_closed(self, _=None):
        for change in self.opens.read():
            self.users += change
            if self.users == 0:
                # Of a real port nothing of this is left when its last user has gone.
                self._share()
                termios.tcflush(self.page, termios.TCIFLUSH)
                self.unsent = b""
                if self.settings:
                    self.settings = None
                    self.say("closed")

    def _ready(self, events):
        if events & selectors.EVENT_WRITE:
            self._write()
        if events & selectors.EVENT_READ:
            self._opened_or_closed()  # before these bytes
            data = os.read(self.device, 65536)
            self._share()
            settings = self._read_settings()
            if not self.settings:
                self.say("opened")
            if settings != self.settings:
                self.settings = settings
                self.say("set", **settings)
            self.say("data", hex=data.hex(" "))

    def _read_settings(self):
        """What the page asked for when it opened the port. A pty knows neither parity nor 7 bits, so these are not told."""
        data = fcntl.ioctl(self.page, self.TCGETS2, bytes(44))
        (flags,), (rate,) = struct.unpack_from("=I", data, 8), struct.unpack_from("=I", data, 40)
        return {
            "baudRate": rate,
            "stopBits": 2 if flags & termios.CSTOPB else 1,
            "flowControl": "hardware" if flags & termios.CRTSCTS else "none",
        }

    def _write(self):
        if self.unsent:
            try:
                self.unsent = self.unsent[os.write(self.device, self.unsent) :]
            except BlockingIOError:
                pass
        events = selectors.EVENT_READ | (selectors.EVENT_WRITE if self.unsent else 0)
        self.selector.modify(self.device, events, self._ready)

    def _drain(self, limit=0.5, calm=0.03):
        """
        Waits until Chromium has taken all that was sent, and a moment more: the kernel hands it over a little later, and in
        Chromium the news that a port is gone can overtake its last bytes.
        """
        now = time.monotonic()
        end, taken = now + limit, now
        while self.users > 0 and now < min(end, taken + calm):
            self._write()
            (unread,) = struct.unpack("=i", fcntl.ioctl(self.page, termios.FIONREAD, bytes(4)))
            now = time.monotonic()
            if unread or self.unsent:
                taken = now
            time.sleep(0.002)


class Opens:
    """Tells by inotify when a file is opened and closed; Python has no call for it."""

    OPEN, CLOSE = 0x20, 0x18

    def __init__(self, path):
        libc = ctypes.CDLL(None, use_errno=True)
        self.fd = libc.inotify_init1(os.O_CLOEXEC | os.O_NONBLOCK)
        if self.fd < 0 or libc.inotify_add_watch(self.fd, path.encode(), self.OPEN | self.CLOSE) < 0:
            raise OSError(ctypes.get_errno(), "inotify")

    def read(self):
        """+1 for each opening, -1 for each closing, in order."""
        try:
            events = os.read(self.fd, 4096)
        except BlockingIOError:
            return []
        return [1 if mask & self.OPEN else -1 for _, mask, _, _ in struct.iter_unpack("=iIII", events)]
