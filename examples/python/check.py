"""Runs the decoder and the encoder on the vectors of the package: python3 check.py [vectors.json]"""

import json
import sys
from pathlib import Path

from sidus import FrameDecoder, encode

default = Path(__file__).parent / "../../test/vectors.json"
vectors = json.loads(Path(sys.argv[1] if len(sys.argv) > 1 else default).read_text())
wrong = 0


def check(name: str, found: object, expected: object) -> None:
    global wrong
    if found != expected:
        wrong += 1
        print(f"WRONG {name}: {found!r} instead of {expected!r}")


def shown(frame: tuple[int, bytes]) -> str:
    return bytes([frame[0], *frame[1]]).hex(" ")


steps = 0
for stream in vectors["streams"]:
    decoder = FrameDecoder(stream.get("quirks", {}).get("bareChecksum", False))
    for step in stream["steps"]:
        steps += 1
        frames = decoder.idle() if "idle" in step else decoder.push(bytes.fromhex(step["push"]))
        check(stream["name"], [shown(frame) for frame in frames], step["frames"])

messages = vectors["requests"] + vectors["replies"]
for message in messages:
    sent = bytes.fromhex(message["hex"])
    is_bare = message.get("quirks", {}).get("bareChecksum", False)
    # The encoder makes a bare checksum for any letter, the decoder accepts it for 76 only: cut this frame out by hand.
    [(code, data)] = [(sent[6], sent[7:-2])] if is_bare else FrameDecoder().push(sent)
    check(message["name"], encode(code, data, is_bare).hex(" "), sent.hex(" "))

print(f"{len(vectors['streams'])} streams in {steps} steps, {len(messages)} messages: {wrong} wrong")
sys.exit(1 if wrong or not steps else 0)
