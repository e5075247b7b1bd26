"""Frames of the Sidus timer protocol, in plain Python 3: what `FrameDecoder` and `encodeFrame` do.

A frame is: five zeros (a decoder accepts four), a length, a command, up to 252 bytes of data, a checksum, 45. The
length counts itself, the command, the data and the checksum. The checksum is the sum of command and data, modulo 256.
"""

ZEROS_SENT, ZEROS_NEEDED = 5, 4
TERMINATOR = 0x45
SHORTEST = 3


def encode(code: int, data: bytes = b"", bare_checksum: bool = False) -> bytes:
    """A frame as it goes on the wire. bare_checksum: puts the command byte in place of the checksum."""
    if not 0 <= code <= 255 or len(data) > 252:
        raise ValueError("a command is 0 to 255, and a frame holds at most 252 bytes of data")
    checksum = code if bare_checksum else (code + sum(data)) & 0xFF
    return bytes([0] * ZEROS_SENT + [SHORTEST + len(data), code, *data, checksum, TERMINATOR])


class FrameDecoder:
    """Finds frames in bytes that may be cut, damaged or noisy. A frame is (command, data). Nothing makes it raise."""

    def __init__(self, bare_checksum: bool = False):
        """bare_checksum: accepts 76 with one byte of data also when its letter stands in place of the checksum."""
        self._bare = bare_checksum
        self._held = bytearray()  # from the length of a frame that is not whole yet
        self._zeros = 0  # directly before what is held, or before the next byte

    def push(self, chunk: bytes) -> list[tuple[int, bytes]]:
        """The frames that became whole with these bytes."""
        held, self._held = self._held + chunk, bytearray()
        return self._scan(held)

    def idle(self) -> list[tuple[int, bytes]]:
        """The line has fallen silent: gives up an unfinished frame and looks for frames inside its bytes."""
        frames = []
        while self._held:
            held, self._held, self._zeros = self._held[1:], bytearray(), 0
            frames += self._scan(held)
        return frames

    def _scan(self, held: bytearray) -> list[tuple[int, bytes]]:
        frames, at = [], 0
        while at < len(held):
            length = held[at]
            if length == 0:
                self._zeros += 1
                at += 1
                continue
            if self._zeros >= ZEROS_NEEDED and length >= SHORTEST:
                if at + length >= len(held):
                    self._held = held[at:]
                    return frames
                if self._is_frame(held[at : at + length + 1]):
                    frames.append((held[at + 1], bytes(held[at + 2 : at + length - 1])))
                    at += length
            # Not a frame: the next one may begin with the byte after this length.
            self._zeros = 0
            at += 1
        return frames

    def _is_frame(self, frame: bytearray) -> bool:
        code, checksum = frame[1], frame[-2]
        if frame[-1] != TERMINATOR:
            return False
        is_bare = self._bare and code == 0x76 and len(frame) == 5 and checksum == code
        return is_bare or checksum == sum(frame[1:-2]) & 0xFF
