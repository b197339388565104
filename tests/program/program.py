"""Calls the program as a user does, in a folder of its own for every test."""
import json
import os
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

PROGRAM = os.environ["WUERFEL"]

FLOOR = {"name": "floor", "point": [0, 0], "normal": [0, 1]}

# One cube in free flight: needs no solver, so runs of it are quick.
FLYING = {"version": 1, "title": "flying", "duration": 1.0,
          "cube": [{"name": "a", "position": [0, 10], "velocity": [1, 0]}]}
STANDING = {"version": 1, "title": "standing", "duration": 0.1, "plane": [FLOOR],
            "cube": [{"name": "a", "position": [0, 0.5]}]}
# Half of the upper cube's weight and a bit more hangs over the edge.
FALLING = {"version": 1, "title": "falling", "duration": 0.1, "plane": [FLOOR],
           "cube": [{"name": "a", "position": [0, 0.5]}, {"name": "b", "position": [0.6, 1.5]}]}
# The cube arrives at the floor at t = 0.
LANDING = {"version": 1, "title": "landing", "duration": 0.05, "plane": [FLOOR],
           "cube": [{"name": "a", "position": [0, 0.5], "velocity": [0, -2]}]}

FLYING_TOML = """
version = 1
title = "flying"
duration = 1.0
[[cube]]
name = "a"
position = [0.0, 10.0]
velocity = [1.0, 0.0]
"""


def comma_locale(folder):
    """The environment of a locale with decimal commas, which is made in the folder: none needs to be installed."""
    subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", os.path.join(folder, "de_DE.UTF-8")], check=True, capture_output=True)
    environment = {**os.environ, "LOCPATH": folder, "LC_ALL": "de_DE.UTF-8"}
    point = subprocess.run(["locale", "decimal_point"], env=environment, check=True, capture_output=True, text=True).stdout
    assert point == ",\n", point
    return environment


class ProgramTest(unittest.TestCase):
    program = PROGRAM

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="wuerfel-test-")
        self.addCleanup(shutil.rmtree, self.folder)

    def path(self, name):
        return os.path.join(self.folder, name)

    def files(self, folder="."):
        """All names in the folder, hidden ones too."""
        return sorted(os.listdir(self.path(folder)))

    def content(self, name):
        with open(self.path(name)) as file:
            return file.read()

    def scene(self, scene, name="scene.json"):
        with open(self.path(name), "w") as file:
            json.dump(scene, file)
        return self.path(name)

    def call(self, *arguments, **options):
        """The finished process; text output unless options say otherwise."""
        settings = {"capture_output": True, "text": True, "cwd": self.folder, "timeout": 120}
        settings.update(options)
        return subprocess.run([self.program, *arguments], **settings)

    def expect(self, code, *arguments, **options):
        """Calls and fails unless the exit code is `code`."""
        done = self.call(*arguments, **options)
        self.assertEqual(done.returncode, code, f"{arguments}: {done.stderr}")
        return done

    def refuse(self, *arguments):
        """What the program says of arguments that it does not take."""
        done = self.expect(2, *arguments)
        self.assertEqual(done.stdout, "", arguments)
        self.assertTrue(done.stderr.startswith("wuerfel: "), done.stderr)
        return done.stderr

    def summary(self, scene, *arguments, code=0):
        done = self.expect(code, "run", self.scene(scene), "--json", *arguments)
        return json.loads(done.stdout)


def png_chunks(path):
    """(type, content) of every chunk, each checked against its CRC."""
    with open(path, "rb") as file:
        data = file.read()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", path
    chunks, at = [], 8
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        content = data[at + 8:at + 8 + length]
        assert zlib.crc32(kind + content) == struct.unpack(">I", data[at + 8 + length:at + 12 + length])[0], path
        chunks.append((kind.decode(), content))
        at += 12 + length
    assert chunks[-1][0] == "IEND", path
    return chunks


def png_size(path):
    return struct.unpack(">II", png_chunks(path)[0][1][:8])


def png_texts(path):
    """Keyword -> text of the text chunks."""
    texts = {}
    for kind, content in png_chunks(path):
        keyword, _, rest = content.partition(b"\0")
        if kind == "tEXt":
            texts[keyword.decode()] = rest.decode("latin-1")
        elif kind == "zTXt":
            texts[keyword.decode()] = zlib.decompress(rest[1:]).decode("latin-1")
        elif kind == "iTXt":
            compressed, rest = rest[0], rest[2:].split(b"\0", 2)[2]
            texts[keyword.decode()] = (zlib.decompress(rest) if compressed else rest).decode("utf-8")
    return texts


def main():
    sys.dont_write_bytecode = True
    signal.signal(signal.SIGINT, signal.default_int_handler)  # shells have jobs in the background ignore it
    unittest.main(verbosity=2)
