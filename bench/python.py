"""What Python adds: batches of pairs of boxes beside the same batch in C++, and questions about one pair.

    PYTHONPATH=build/release/python /usr/bin/python3 bench/python.py --boxes build/release/bin/bench_boxes

Both are asked about the same pairs in turns, in one sitting, and have to give the same answers. The shapes are a
ShapeArray and the poses arrays of rows, as a caller holds them who asks more than once; in C++ they are arrays of
`Box<double>` and `Pose<double>`. Told are medians of the processor's time, which other work on the machine moves less
than the clock's, and the median of the ratios of neighbours. A table in Markdown goes to the standard output.
"""

import argparse
import json
import os
import statistics
import subprocess
import tempfile
import time

import numpy as np

import graze


class Pairs:
    """Pairs of boxes of edges from 0.4 to 2, about half of which overlap."""

    def __init__(self, count):
        random = np.random.default_rng(1)
        self.sizes_a, self.poses_a = random.uniform(0.4, 2, (count, 3)), self._poses(random, count)
        self.sizes_b, self.poses_b = random.uniform(0.4, 2, (count, 3)), self._poses(random, count)
        way = random.normal(size=(count, 3))
        way /= np.linalg.norm(way, axis=1, keepdims=True)
        apart = random.uniform(0.4, 2.4, (count, 1))
        self.poses_b[:, :3] = self.poses_a[:, :3] + way * apart
        self.a, self.b = graze.ShapeArray.boxes(self.sizes_a), graze.ShapeArray.boxes(self.sizes_b)

    @staticmethod
    def _poses(random, count):
        poses = random.normal(size=(count, 7))
        poses[:, 3:] /= np.linalg.norm(poses[:, 3:], axis=1, keepdims=True)
        return poses

    def write(self, file):
        np.hstack([self.sizes_a, self.poses_a, self.sizes_b, self.poses_b]).tofile(file)


class InCpp:
    """The program bench_boxes, which waits for questions."""

    def __init__(self, program, file):
        self._process = subprocess.Popen(
            [program, "--rows", file], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )

    def ask(self, query, times):
        """Seconds of each time, and the sum over an answer."""
        self._process.stdin.write(f"{query} {times}\n")
        self._process.stdin.flush()
        answer = json.loads(self._process.stdout.readline())
        return answer["seconds"], answer["sum"]

    def close(self):
        self._process.stdin.close()
        self._process.wait()


class InPython:
    """The same by the package."""

    def __init__(self, pairs):
        self._pairs = pairs

    def ask(self, query, times):
        p, seconds = self._pairs, []
        asked = getattr(graze.batch, query)
        for _ in range(times):
            begin = time.thread_time()
            found = asked(p.a, p.poses_a, p.b, p.poses_b)
            seconds.append(time.thread_time() - begin)
        return seconds, self._sum(query, found)

    @staticmethod
    def _sum(query, found):
        if query == "overlap":
            return float(found.sum())
        return float((found if query == "distance" else found[2])["distance"].sum())


def race(query, cpp, python, rounds):
    """Medians of both, in seconds, and of the ratio. The first round, of caches and pages, does not count."""
    of_cpp, of_python = [], []
    for i in range(rounds + 1):
        a, sum_a = cpp.ask(query, 3)
        b, sum_b = python.ask(query, 3)
        assert abs(sum_a - sum_b) <= 1e-9 * max(1, abs(sum_a)), (query, sum_a, sum_b)
        if i > 0:
            of_cpp.append(statistics.median(a))
            of_python.append(statistics.median(b))
    ratio = statistics.median(p / c for p, c in zip(of_python, of_cpp))
    return statistics.median(of_cpp), statistics.median(of_python), ratio


def one_pair(query, rounds, calls=20000):
    """Seconds of a call about one pair, the median of `rounds` loops."""
    a, b = graze.Box((1, 2, 3)), graze.Box((2, 1, 1))
    at, there = graze.Pose((0, 0, 0)), graze.Pose((1.2, 0.3, 0.1), (0.1, 0.2, 0.3, 0.9))
    asked, seconds = getattr(graze, query), []
    for _ in range(rounds):
        begin = time.thread_time()
        for _ in range(calls):
            asked(a, at, b, there)
        seconds.append((time.thread_time() - begin) / calls)
    return statistics.median(seconds)


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--boxes", required=True, metavar="PROGRAM", help="the program bench_boxes")
    arguments.add_argument("--pairs", type=int, default=100_000, help="pairs of a batch (default: %(default)s)")
    arguments.add_argument("--rounds", type=int, default=15, help="turns, at least 9 (default: %(default)s)")
    options = arguments.parse_args()
    if options.rounds < 9 or options.pairs < 1:
        arguments.error("at least 9 rounds and a pair")
    pairs = Pairs(options.pairs)
    queries = ("overlap", "distance", "contacts")
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "boxes")
        pairs.write(file)
        cpp = InCpp(options.boxes, file)
        print(f"| {options.pairs} pairs of boxes | C++, ms | Python, ms | ratio |\n|---|---:|---:|---:|")
        for query in queries:
            c, p, ratio = race(query, cpp, InPython(pairs), options.rounds)
            print(f"| {query} | {1e3 * c:.2f} | {1e3 * p:.2f} | {ratio:.2f} |")
        cpp.close()
    print("\n| one pair of boxes | µs |\n|---|---:|")
    for query in queries:
        print(f"| {query} | {1e6 * one_pair(query, options.rounds):.2f} |")


if __name__ == "__main__":
    main()
