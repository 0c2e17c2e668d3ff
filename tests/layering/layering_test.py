# SPDX-License-Identifier: GPL-3.0-or-later
"""What may include what.

Reads every #include of the sources and compares it with the table below. The compiler finds most back edges too, because
each room has its own include root; it does not find a system library used in the wrong room.
"""

import os
import re
import unittest

ROOT = os.environ.get("TWOSCALE_SOURCE_DIR") or os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

# The namespace of its headers (twoscale/<name>/...), its directory, the rooms it may see, the third-party header prefixes.
ALGEBRA = ("ginac/", "cln/", "flint/", "arb", "acb", "arf.h", "mag.h", "fmpz", "fmpq", "gmp.h", "gmpxx.h", "mpfr.h")
ROOMS = {
    "symbolic": ("symbolic", (), ALGEBRA + ("fmt/", "toml++/", "nlohmann/")),
    "analysis": ("analysis", ("symbolic",),
                 ("nlohmann/", "fmt/", "Eigen/", "glpk.h", "arb", "acb", "arf.h", "mag.h", "flint/", "fmpz", "fmpq")),
    "check": ("analysis/check", (), ("boost/multiprecision/",)),
    "kernels": ("numeric/kernels", (), ("nlohmann/", "hwy/", "tbb/", "oneapi/tbb/")),
    "lowering": ("numeric/lowering", ("symbolic", "kernels"), ("fmt/", "arb", "acb", "arf.h", "mag.h", "flint/", "fmpz", "fmpq")),
    "reports": ("reports", ("analysis", "symbolic", "lowering", "kernels"), ("nlohmann/", "fmt/", "toml++/")),
}
# Above the rooms; they may see all of them.
PROGRAMS = {
    "cli": ("CLI/", "nlohmann/", "fmt/", "toml++/"),
}
# The one program that may see the checker only.
CHECK_MAIN = "cli/check_main.cpp"

STANDARD = set("""
algorithm any array atomic barrier bit bitset charconv chrono codecvt compare complex concepts condition_variable coroutine
deque exception execution filesystem forward_list fstream functional future initializer_list iomanip ios iosfwd iostream
istream iterator latch limits list locale map memory memory_resource mutex new numbers numeric optional ostream queue random
ranges ratio regex scoped_allocator semaphore set shared_mutex source_location span sstream stack stdexcept stop_token
streambuf string string_view syncstream system_error thread tuple type_traits typeindex typeinfo unordered_map
unordered_set utility valarray variant vector version
cassert cctype cerrno cfenv cfloat cinttypes climits clocale cmath csetjmp csignal cstdarg cstddef cstdint cstdio cstdlib
cstring ctime cuchar cwchar cwctype
""".split())
SYSTEM = {"unistd.h", "sys/types.h", "sys/stat.h", "sys/wait.h", "sys/resource.h", "fcntl.h", "signal.h", "spawn.h",
          "stdio.h", "stdlib.h", "poll.h", "sched.h", "immintrin.h", "sys/mman.h", "pthread.h"}

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.MULTILINE)
COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
SOURCE = (".hpp", ".cpp", ".h", ".inc")


def sources(directory, without=()):
    for folder, folders, files in os.walk(os.path.join(ROOT, directory)):
        folders[:] = sorted(f for f in folders
                            if os.path.relpath(os.path.join(folder, f), ROOT) not in without)
        for name in sorted(files):
            if name.endswith(SOURCE):
                yield os.path.relpath(os.path.join(folder, name), ROOT)


def includes(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return [(m.group(1), m.group(2)) for m in INCLUDE.finditer(COMMENT.sub("", file.read()))]


def offence(path, bracket, header, own, rooms, third_party):
    """Why a file of the room `own` may not include the header, or None."""
    if header.startswith("twoscale/"):
        room = header.split("/")[1]
        if room not in ROOMS:
            return f"{room} is not a room"
        return None if room in (own, *rooms) else f"{own} may not see {room}"
    if ".." in header.split("/"):
        return "a path with .. leaves the include root"
    if header in STANDARD or header in SYSTEM:
        return None
    if any(header.startswith(prefix) for prefix in third_party):
        return None
    if bracket == '"':
        directory = os.path.dirname(os.path.join(ROOT, path))
        private = os.path.join(ROOT, ROOMS[own][0], "src") if own in ROOMS else os.path.join(ROOT, own)
        if any(os.path.exists(os.path.join(base, header)) for base in (directory, private)):
            return None
        return "not a header of this room (rooms are spelled twoscale/<room>/...)"
    return f"{own} may not use <{header}>"


class Layering(unittest.TestCase):
    def verify(self, files, own, rooms, third_party):
        wrong = []
        for path in files:
            for bracket, header in includes(path):
                reason = offence(path, bracket, header, own, rooms, third_party)
                if reason:
                    wrong.append(f"{path}: {header}: {reason}")
        self.assertEqual(wrong, [], "\n" + "\n".join(wrong))

    def test_rooms(self):
        for name, (directory, rooms, third_party) in ROOMS.items():
            with self.subTest(room=name):
                nested = [d for d, _, _ in ROOMS.values() if d.startswith(directory + "/")]
                self.verify(sources(directory, nested), name, rooms, third_party)

    def test_programs(self):
        for directory, third_party in PROGRAMS.items():
            files = [f for f in sources(directory) if f != CHECK_MAIN]
            self.verify(files, directory, tuple(ROOMS), third_party)

    def test_checker_program(self):
        if os.path.exists(os.path.join(ROOT, CHECK_MAIN)):
            self.verify([CHECK_MAIN], "cli", ("check",), ())

    def test_public_headers_stand_in_their_own_room(self):
        for name, (directory, _, _) in ROOMS.items():
            root = os.path.join(directory, "include")
            for path in sources(root):
                self.assertTrue(path.startswith(os.path.join(root, "twoscale", name) + os.sep), path)

    def test_every_file_names_its_licence(self):
        missing = []
        for directory in [d for d, _, _ in ROOMS.values() if "/check" not in d] + ["cli", "bench", "tests"]:
            licence = "0BSD" if directory == "numeric/kernels" else "GPL-3.0-or-later"
            for path in sources(directory):
                with open(os.path.join(ROOT, path), encoding="utf-8") as file:
                    if not file.readline().startswith(f"// SPDX-License-Identifier: {licence}"):
                        missing.append(f"{path}: first line is not // SPDX-License-Identifier: {licence}")
        self.assertEqual(missing, [], "\n" + "\n".join(missing))

    def test_the_table_refuses(self):
        """The table can fail: back edges and foreign libraries are named."""
        for own, header in [("symbolic", "twoscale/analysis/verdict.hpp"), ("analysis", "twoscale/kernels/refine.hpp"),
                            ("kernels", "twoscale/symbolic/laurent.hpp"), ("check", "twoscale/symbolic/laurent.hpp"),
                            ("kernels", "ginac/ginac.h"), ("kernels", "gmp.h"), ("kernels", "arb.h"), ("check", "gmpxx.h"),
                            ("check", "boost/algorithm/string.hpp"), ("analysis", "ginac/ginac.h"),
                            ("lowering", "twoscale/analysis/verdict.hpp"), ("lowering", "ginac/ginac.h")]:
            directory, rooms, third_party = ROOMS[own]
            self.assertIsNotNone(offence(directory + "/src/x.cpp", "<", header, own, rooms, third_party), f"{own}: {header}")


if __name__ == "__main__":
    unittest.main()
