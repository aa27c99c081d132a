# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""Holds _core.pyi to the module: names, arguments, their order and which must be named."""
import ast
import inspect
import re
import unittest
from pathlib import Path

import surefoot
from surefoot import _core

STUB = ast.parse((Path(_core.__file__).parent / "_core.pyi").read_text())


def of_stub(node):
    """Arguments of a function: (name, has default, must be named)."""
    arguments = node.args
    plain = [a.arg for a in arguments.args]
    with_default = plain[len(plain) - len(arguments.defaults) :]
    result = [(name, name in with_default, False) for name in plain]
    for argument, default in zip(arguments.kwonlyargs, arguments.kw_defaults):
        result.append((argument.arg, default is not None, True))
    if arguments.kwarg:
        result.append((f"**{arguments.kwarg.arg}", False, True))
    return result


def of_signature(text):
    """The same from the first line that pybind11 writes into a docstring."""
    inside = text[text.index("(") + 1 : text.rindex(") ->")]
    parts, depth, start = [], 0, 0
    for i, c in enumerate(inside):
        depth += (c in "([{") - (c in ")]}")
        if c == "," and depth == 0:
            parts.append(inside[start:i])
            start = i + 1
    parts.append(inside[start:])
    result, named = [], False
    for part in (part.strip() for part in parts):
        if part == "*":
            named = True
        elif part:
            name = re.match(r"\**\w+", part).group()
            result.append((name, " = " in part, named or name.startswith("**")))
    return result


def signatures(member):
    return [
        line.split(". ", 1)[-1]
        for line in (member.__doc__ or "").splitlines()
        if re.match(r"(\d+\. )?\w+\(.*\) -> ", line)
    ]


class StubTest(unittest.TestCase):
    def test_every_name_is_there(self):
        stubbed = {n.name for n in STUB.body if isinstance(n, (ast.ClassDef, ast.FunctionDef))}
        here = {n for n in vars(_core) if not n.startswith("_")}
        self.assertEqual(here - stubbed, set())
        if hasattr(_core, "simulate"):
            self.assertEqual(stubbed, here)

    def test_every_member_is_there(self):
        hidden = {"__init__", "__doc__", "__module__", "__repr__", "__eq__", "__hash__", "__str__"}
        hidden.add("__entries")  # of pybind11's enumerations
        for node in STUB.body:
            real = getattr(_core, getattr(node, "name", ""), None)
            if not isinstance(node, ast.ClassDef) or real is None:
                continue
            if issubclass(real, Exception):
                continue
            stubbed = {n.name for n in node.body if isinstance(n, ast.FunctionDef)}
            stubbed |= {n.target.id for n in node.body if isinstance(n, ast.AnnAssign)}
            here = {n for n in vars(real) if not n.startswith("_pybind11")}
            self.assertEqual(stubbed - hidden, here - hidden, node.name)

    def test_arguments_agree(self):
        checked = 0
        for owner, node, real in self.functions():
            decorators = {d.id for d in node.decorator_list if isinstance(d, ast.Name)}
            found = signatures(real)
            if "property" in decorators or not found or len(found) > 1:
                continue
            mine, theirs = of_stub(node), of_signature(found[0])
            if owner and "staticmethod" not in decorators:
                mine, theirs = mine[1:], theirs[1:]  # self
            if node.name.startswith("__") and node.name != "__init__":
                mine = [(name, False, False) for name, _, _ in mine]
                theirs = [(name, False, False) for name, _, _ in theirs]
            self.assertEqual(mine, theirs, f"{owner}.{node.name}")
            checked += 1
        self.assertGreater(checked, 30)

    def functions(self):
        for node in STUB.body:
            if isinstance(node, ast.FunctionDef) and hasattr(_core, node.name):
                yield "", node, getattr(_core, node.name)
            elif isinstance(node, ast.ClassDef) and hasattr(_core, node.name):
                owner = getattr(_core, node.name)
                for member in node.body:
                    if isinstance(member, ast.FunctionDef) and hasattr(owner, member.name):
                        if not any(isinstance(d, ast.Attribute) for d in member.decorator_list):
                            yield node.name, member, getattr(owner, member.name)

    def test_everything_public_is_explained(self):
        for name in surefoot.__all__:
            self.assertTrue(getattr(surefoot, name).__doc__, name)
        for name in dir(surefoot):
            if not name.startswith("_") and not inspect.ismodule(getattr(surefoot, name)):
                self.assertIn(name, surefoot.__all__)


if __name__ == "__main__":
    unittest.main()
