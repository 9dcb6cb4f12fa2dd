#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the tests of a build folder and counts their cases; called by scripts/test.

ctest knows every registered test and its exit code, the xunit files of gtest and rostest know the cases. Both
are needed: a program that dies after its last case leaves a clean file, one that dies before leaves none.
"""

import argparse
import collections
import json
import os
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

# Longer than rostest's own limits, with which a test ends cleanly.
TIMEOUT_SECONDS = 900

Case = collections.namedtuple("Case", "name outcome message")


def read_cases(path):
    """The cases of an xunit file. A missing or truncated file is one failed case."""
    try:
        root = ElementTree.parse(path).getroot()
    except (OSError, ElementTree.ParseError) as error:
        return [Case(path.stem, "failed", "no readable result: %s" % error)]
    return [read_case(path, element) for element in root.iter("testcase")]


def read_case(path, element):
    name = "%s: %s.%s" % (path.stem, element.get("classname", ""), element.get("name", ""))
    problems = [child for child in element if child.tag in ("failure", "error")]
    if problems:
        text = "\n".join(p.text or p.get("message") or "" for p in problems)
        return Case(name, "failed", text.strip())
    skipped = element.find("skipped")
    if skipped is not None:
        return Case(name, "skipped", (skipped.get("message") or skipped.text or "").strip())
    if element.get("result") == "skipped" or element.get("status") == "notrun":
        return Case(name, "skipped", "disabled" if element.get("status") == "notrun" else "")
    return Case(name, "passed", "")


def rostest_cases(path, seen):
    """The cases of a rostest. Its own file has one case per test program, which only states whether the
    program left a result, and the name of the file with the cases of the program."""
    cases = [case for case in read_cases(path) if case.outcome != "passed"]
    text = path.read_text(errors="replace") if path.exists() else ""
    for inner in re.findall(r"results are in \[([^\]]+)\]", text):
        if inner in seen:
            cases.append(Case(inner, "failed", "a second test has the same test-name: it overwrote this result"))
            continue
        seen.add(inner)
        cases += read_cases(pathlib.Path(inner))
    return cases


def result_file(test):
    """The xunit file that a ctest entry writes, None if it has only an exit code."""
    command = test.get("command", [])
    for word, following in zip(command, command[1:]):
        if word.endswith("/run_tests.py"):
            return pathlib.Path(following)
    return None


def cases_of(test, failed_tests, seen):
    """All cases of one ctest entry: at least one, and at least one failed if ctest reports a failure."""
    name, path = test["name"], result_file(test)
    if path is None:
        return [Case(name, "failed", "it ended with an error") if name in failed_tests else Case(name, "passed", "")]
    cases = rostest_cases(path, seen) if path.name.startswith("rostest-") else read_cases(path)
    if name in failed_tests and not any(case.outcome == "failed" for case in cases):
        cases.append(Case(name, "failed", "it ended with an error, though no case of it failed"))
    if not cases:
        cases.append(Case(name, "failed", "it ran no case at all"))
    return cases


def read_patterns(path):
    """Reasons by regular expressions of tests' names, from lines of both."""
    lines = [line.split(None, 1) for line in path.read_text().splitlines() if line and not line.startswith("#")]
    return {name: reason for name, reason in lines}


def list_tests(build, selection):
    """The ctest descriptions of the tests selected by these options."""
    listing = subprocess.run(["ctest", "--show-only=json-v1"] + selection, cwd=build, check=True,
                             stdout=subprocess.PIPE)
    return json.loads(listing.stdout)["tests"]


def skipped_cases(build, only, without, reasons):
    """One skipped case per selected but excluded test. A reason that applies to no test is an error."""
    everything = [test["name"] for test in list_tests(build, [])]
    for pattern in reasons:
        if not any(re.search(pattern, name) for name in everything):
            sys.exit("no test is left out by '%s', as there is none of such a name" % pattern)
    run = {test["name"] for test in list_tests(build, only + without)}
    left_out = [test["name"] for test in list_tests(build, only) if test["name"] not in run]
    return [Case(name, "skipped", next(reason for pattern, reason in reasons.items() if re.search(pattern, name)))
            for name in left_out]


def batches_of(tests, serial):
    """The tests in groups that run one after the other, each with how many tests run at a time: programs that compute,
    one per processor; rostests, which mostly wait, two per processor; tests that must be alone."""
    processors = os.cpu_count() or 1
    batches = {"computing": [], "waiting": [], "alone": []}
    for test in tests:
        alone = any(re.search(pattern, test["name"]) for pattern in serial)
        waits = "_rostest_" in test["name"]
        batches["alone" if alone else "waiting" if waits else "computing"].append(test)
    return [(batches["computing"], processors), (batches["waiting"], 2 * processors), (batches["alone"], 1)]


def run_batch(build, numbers, jobs):
    """Runs the tests of these numbers; returns the set of names of those that failed."""
    failures = build / "Testing" / "Temporary" / "LastTestsFailed.log"
    failures.unlink(missing_ok=True)
    # Start, end and stride of 0: only the numbers behind them.
    selection = ",".join(["0", "0", "0"] + [str(number) for number in numbers])
    status = subprocess.run(["ctest", "--output-on-failure", "--timeout", str(TIMEOUT_SECONDS), "--parallel", str(jobs),
                             "--tests-information", selection], cwd=build).returncode
    failed = {line.split(":", 1)[1] for line in failures.read_text().splitlines()} if failures.exists() else set()
    if status != 0 and not failed:
        sys.exit("ctest itself failed (%d)" % status)
    return failed


def run_ctest(build, selection, serial):
    """Runs the tests. Returns their ctest descriptions and the names of the failed ones."""
    number_of = {test["name"]: number for number, test in enumerate(list_tests(build, []), 1)}
    tests = list_tests(build, selection)
    for path in filter(None, map(result_file, tests)):
        path.unlink(missing_ok=True)
    failed = set()
    for batch, jobs in batches_of(tests, serial):
        if batch:
            failed |= run_batch(build, [number_of[test["name"]] for test in batch], jobs)
    return tests, failed


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=pathlib.Path, help="build folder")
    parser.add_argument("--only", metavar="REGEX", help="run only the tests whose name matches")
    parser.add_argument("--serial", metavar="FILE", type=pathlib.Path,
                        help="tests that run alone, each with the reason; without it, all of them do")
    parser.add_argument("--skip", metavar="FILE", type=pathlib.Path, help="tests that are left out, each with the reason")
    arguments = parser.parse_args()

    reasons = read_patterns(arguments.skip) if arguments.skip else {}
    serial = read_patterns(arguments.serial) if arguments.serial else [""]
    only = ["-R", arguments.only] if arguments.only else []
    without = ["-E", "|".join(reasons)] if reasons else []
    cases = skipped_cases(arguments.build, only, without, reasons)
    tests, failed_tests = run_ctest(arguments.build, only + without, serial)
    seen = set()
    cases += [case for test in tests for case in cases_of(test, failed_tests, seen)]

    for outcome in ("skipped", "failed"):
        for case in cases:
            if case.outcome == outcome:
                print("\n%s: %s\n    %s" % (outcome, case.name, case.message.replace("\n", "\n    ")))

    count = collections.Counter(case.outcome for case in cases)
    print("\n%d passed, %d failed, %d skipped" % (count["passed"], count["failed"], count["skipped"]))
    return 1 if count["failed"] or not count["passed"] else 0


if __name__ == "__main__":
    sys.exit(main())
