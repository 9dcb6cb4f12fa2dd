#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes a header from its template, in which @parameters@ stands for the names, defaults, bounds and meanings of the
method's parameters. They are read from the file that dynamic_reconfigure reads, without dynamic_reconfigure.

Usage: parameter_help.py CFG PARAMETERS_H TEMPLATE OUTPUT
"""
import re
import sys
import textwrap
import types


class Generator:
    """Records what a .cfg file adds, in the place of dynamic_reconfigure's own generator."""

    def __init__(self):
        self.parameters = []

    def add(self, name, kind, level, text, default, minimum=None, maximum=None, edit_method=None):
        self.parameters.append((name, text, default, minimum, maximum, edit_method))

    def add_group(self, *_, **__):
        return self

    def const(self, name, kind, value, text):
        return name, value, text

    def enum(self, constants, text):
        return dict((value, name) for name, value, _ in constants)

    def generate(self, *_):
        return 0


def read(cfg):
    module = types.ModuleType("parameter_generator_catkin")
    generator = Generator()
    module.ParameterGenerator = lambda: generator
    module.bool_t, module.double_t, module.int_t, module.str_t = "bool", "double", "int", "str"
    sys.modules["dynamic_reconfigure"] = types.ModuleType("dynamic_reconfigure")
    sys.modules["dynamic_reconfigure.parameter_generator_catkin"] = module
    with open(cfg, encoding="utf-8") as stream:
        try:
            exec(compile(stream.read(), cfg, "exec"), {"__name__": "cfg"})
        except SystemExit:  # a .cfg file ends with exit(gen.generate(...))
            pass
    return generator.parameters


def describe(name, text, default, minimum, maximum, choices):
    if choices:
        values = "default '%s'; %s" % (choices[default], ", ".join("'%s'" % name for name in choices.values()))
    elif minimum is None:
        values = "default %s" % default
    else:
        values = "default %g; %g to %g" % (default, minimum, maximum)
    return textwrap.fill("%s: %s (%s)" % (name, text, values), 112, subsequent_indent="    ",
                         break_long_words=False, break_on_hyphens=False)


def main(cfg, parameters_h, template, output):
    with open(parameters_h, encoding="utf-8") as stream:
        methods_own = set(re.findall(r'visitor\("(\w+)"', stream.read()))
    lines = [describe(*parameter) for parameter in read(cfg) if parameter[0] in methods_own]
    if len(lines) != len(methods_own):
        sys.exit("parameter_help.py: %s does not describe all parameters of %s" % (cfg, parameters_h))
    with open(template, encoding="utf-8") as stream:
        text = stream.read().replace("@parameters@", "\n".join(lines))
    with open(output, "w", encoding="utf-8") as stream:
        stream.write(text)


if __name__ == "__main__":
    main(*sys.argv[1:])
