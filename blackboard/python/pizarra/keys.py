"""The keys that a client shows to a board that other machines reach: NAME.secret, and board.key beside it.

    name, keys = read_keys("keys/desk.secret")
"""

from __future__ import annotations

import os
import re
import stat
import struct
from typing import Any, List, NamedTuple, Tuple, Union

from zmq.utils import z85

from pizarra.failure import Failure
from pizarra.reader import LETTERS, read
from pizarra.writer import write

Path = Union[str, "os.PathLike[str]"]


class Keys(NamedTuple):
    server: str
    public: str
    secret: str


def read_keys(path: Path) -> Tuple[str, Keys]:
    """The name in the secret, (secret-key NAME PUBLIC SECRET), and three keys: the board's, (key board PUBLIC) beside it,
    and both of the secret."""
    name, public, secret = _read_key(path, "secret-key", 2)
    if os.stat(path).st_mode & (stat.S_IRWXG | stat.S_IRWXO):
        raise Failure("exposed-key", "others may read this secret: chmod 600 it, and make a new key", str(path))
    _, server = _read_key(os.path.join(os.path.dirname(path), "board.key"), "key", 1)
    return name, Keys(server, public, secret)


def _read_key(path: Path, head: str, count: int) -> List[Any]:
    try:
        with open(path, encoding="utf-8") as file:
            form = read(file.read(1 << 16))
    except OSError as error:
        raise Failure("unreadable-file", f"{path}: {error.strerror}", str(path)) from None
    except (UnicodeDecodeError, Failure) as error:
        raise Failure("bad-key", f"{path}: {error}", str(path)) from None
    written = rf'\({head} {LETTERS}(?: "[^"]{{40}}"){{{count}}}'
    try:
        if re.match(written, write(form)) and all(map(z85.decode, form[2:2 + count])):
            return list(form[1:2 + count])
    except (ValueError, KeyError, struct.error, Failure):
        pass  # 40 characters, and not of Z85; or deeper than anything is written
    raise Failure("bad-key", f"{path}: this file holds one form, ({head} NAME KEY ...), each KEY 40 characters of Z85",
                  str(path))
